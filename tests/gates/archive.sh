#!/usr/bin/env bash
# archive.sh qtraj.h libqtraj.a: the only global symbols are the functions of the header; no weak symbol or section group
# is left that the linker could exchange for a copy of the user's; no constructors run before main; no C++ runtime.
set -euo pipefail
export LC_ALL=C
functions=$("$(dirname "$0")/functions.sh" "$1")

echo "the header against the archive:"
diff <(sed 's/$/ T/' <<<"$functions") <(nm --extern-only --defined-only --format=posix "$2" |
  awk 'NF > 2 {print $1, $2}' | sort)

undefined=$(nm --undefined-only --format=posix "$2" | awk 'NF > 1 {print $1}')
if grep -E '^(_Z|__cxa|__gxx|_Unwind)' <<<"$undefined"; then
  echo "needs a C++ runtime"
  exit 1
fi
sections=$(readelf -SW "$2")
if grep -E ' GROUP | \.(init_array|ctors|tdata|tbss)' <<<"$sections"; then
  echo "section groups, constructors or thread-local data"
  exit 1
fi
echo "the same"
