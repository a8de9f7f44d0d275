#!/usr/bin/env bash
# floors.sh root [--count]: no include of the sources runs upstairs, and Eigen comes in by its one door. The floors, from
# the ground up; a file includes from its own floor and those before it, and src/ nothing of capi/. --count prints how many
# includes run from each floor to each, and how many run upstairs.
set -euo pipefail
floors="include base math simd curve rows targets functions means methods diagnostics capi"
cd "$1"
for folder in src/*/; do
  grep -qw "$(basename "$folder")" <<<"$floors" || { echo "src/$(basename "$folder") is no floor yet: give it a place here"; exit 1; }
done
if grep -rnE '#include <(Eigen|unsupported)/' src capi include | grep -v '^src/math/eigen.hpp:'; then
  echo "Eigen comes in by src/math/eigen.hpp"
  exit 1
fi

# "floor of the file, floor of what it includes, file: header", a line each
arrows() {
  grep -rnoE '^#include "[^"]+"' src capi | sed -E 's/^([^:]+):[0-9]+:#include "([^"]+)"$/\1 \2/' |
    while read -r file header; do
      case $file in capi/*) from=capi ;; *) from=${file#src/} from=${from%%/*} ;; esac
      case $header in
        */*) to=${header%%/*} ;;
        qtraj.h) to=include ;;
        compiled_targets.hpp) to=targets ;;  # written by CMake
        *) to=$from ;;
      esac
      echo "$from $to $file: $header"
    done
}
arrows | awk -v floors="$floors" -v count="${2-}" '
  BEGIN { n = split(floors, name, " "); for (k = 1; k <= n; k++) at[name[k]] = k }
  !($1 in at) || !($2 in at) { print "no floor: " $0; bad++; next }
  $1 != $2 { between[$1 " -> " $2]++; total++ }
  at[$2] > at[$1] { print "upstairs: " substr($0, length($1 $2) + 3); up++ }
  END {
    if (count == "--count") for (a in between) print between[a], a | "sort -k2"
    close("sort -k2")
    print total " includes between floors, " up + 0 " upstairs"
    exit up + bad > 0
  }'
