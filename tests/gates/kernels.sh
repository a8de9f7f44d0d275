#!/usr/bin/env bash
# kernels.sh objects...: the sampling kernels define no weak symbols. The linker keeps one copy of a weak function for
# all: were it the one compiled for AVX2, older processors would stop at it.
set -euo pipefail
[ $# -gt 0 ] || { echo "no kernel objects"; exit 1; }
weak=$(nm --print-file-name --defined-only --demangle "$@" | awk '$2 ~ /^[WwVvu]$/')
if [ -n "$weak" ]; then
  echo "weak symbols:"
  echo "$weak"
  exit 1
fi
echo "$# objects without weak symbols"
