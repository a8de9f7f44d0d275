#!/usr/bin/env bash
# run.sh root library folder eigen: qtraj.hpp names every function of qtraj.h, and its test passes as C++17, 20 and 23 by
# GCC and Clang; as C++23 with std::expected where the standard library has one.
set -euo pipefail
root=$1
library=$2
work=$3
eigen=$4
mkdir -p "$work"

# left out: options are values on the heap, so that they can be moved
left_out="qtraj_options_init"
missing=0
functions=$(sed -n '/^QTRAJ_API/s/.*[ *]\(qtraj_[a-z0-9_]*\)(.*/\1/p' "$root/include/qtraj.h")
[ "$(wc -w <<<"$functions")" -gt 150 ]
for function in $functions; do
  name=${function#qtraj_}
  [[ " $left_out " == *" $function "* ]] && continue
  grep -qE "\b$function\b|QTRAJ_TWINS\(${name%_f32}\)" "$root/include/qtraj.hpp" || { echo "not in qtraj.hpp: $function"; missing=1; }
done
# twins that nothing calls do not count
for name in $(sed -n 's/^QTRAJ_TWINS(\(.*\))$/\1/p' "$root/include/qtraj.hpp"); do
  grep -q "c_$name<Real>\|c_$name<detail::real_of\|c_$name<.*real_of" "$root/include/qtraj.hpp" || { echo "never called: $name"; missing=1; }
done
[ $missing -eq 0 ]

warnings="-Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -Wshadow -Werror"
tried=""
for compiler in g++ clang++; do
  for standard in c++17 c++20 c++2b; do
    echo "$compiler -std=$standard"
    $compiler -std=$standard -O1 $warnings -isystem "$eigen" -I "$root/include" "$root/tests/cpp/test_qtraj_hpp.cpp" \
      -o "$work/test" -L "$(dirname "$library")" -lqtraj -pthread -Wl,-rpath,"$(dirname "$library")"
    tried+=$("$work/test")
  done
done
[ -n "$tried" ] || { echo "no standard library here has std::expected"; exit 1; }
