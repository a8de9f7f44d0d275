#!/usr/bin/env bash
# archive.sh qtraj.h libqtraj.a: visible from outside are the functions of the header; what members share beside them is
# hidden and has a prefix that no program uses; no weak symbol or section group is left that the linker could exchange for a copy of the
# user's, so nothing made of Eigen is shared; no constructors run before main; no C++ runtime.
set -euo pipefail
export LC_ALL=C
functions=$("$(dirname "$0")/functions.sh" "$1")
# of each global symbol that is defined: its visibility and its name
defined=$(readelf -sW "$2" | awk '$5 ~ /GLOBAL|WEAK/ && $7 != "UND" {print $5, $6, $8}' | sort -u)

echo "the header against the archive:"
diff <(sed 's/^/GLOBAL DEFAULT /' <<<"$functions") <(grep ' DEFAULT ' <<<"$defined")

fail=0
report() { echo "$1:"; echo "$2"; fail=1; }
weak=$(grep '^WEAK' <<<"$defined" || true)
[ -z "$weak" ] || report "weak symbols" "$weak"
foreign=$(grep ' HIDDEN ' <<<"$defined" | grep -v '^GLOBAL HIDDEN qtraj_internal_' || true)
[ -z "$foreign" ] || report "hidden symbols without the prefix" "$foreign"
runtime=$(nm --undefined-only --format=posix "$2" | awk 'NF > 1 {print $1}' |
  grep -E '^(_Zn|_Zd|_ZSt|_ZNSt|_ZTV|__cxa|__gxx|_Unwind)' || true)
[ -z "$runtime" ] || report "needs a C++ runtime" "$runtime"
sections=$(readelf -SW "$2" | grep -E ' GROUP | \.(init_array|ctors|tdata|tbss)' || true)
[ -z "$sections" ] || report "section groups, constructors or thread-local data" "$sections"
exit $fail
