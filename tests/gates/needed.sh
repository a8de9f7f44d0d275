#!/usr/bin/env bash
# needed.sh libqtraj.so: at run time it needs at most libc and libm; its tables become read-only before it runs.
set -euo pipefail
dynamic=$(readelf -dW "$1")
others=$(sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' <<<"$dynamic" | grep -Ev '^(libc|libm)\.' || true)
if [ -n "$others" ]; then
  echo "needs more than libc and libm:" $others
  exit 1
fi
grep -q 'Library soname: \[libqtraj\.so\.0\]' <<<"$dynamic" || { echo "wrong soname"; exit 1; }
grep -q 'BIND_NOW' <<<"$dynamic" || { echo "not linked with -z now"; exit 1; }
if grep -q 'TEXTREL' <<<"$dynamic"; then echo "relocations in code"; exit 1; fi
segments=$(readelf -lW "$1")
grep -q 'GNU_RELRO' <<<"$segments" || { echo "not linked with -z relro"; exit 1; }
