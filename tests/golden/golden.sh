#!/usr/bin/env bash
# golden.sh expected.txt qtraj_golden [target]: the hashes of the kernel for this CPU, or of that target, are the published
# ones of its arithmetic. Exits with 77 (skipped, with a line that says so) where this CPU has no such kernel.
# golden.sh --update expected.txt qtraj_golden: publishes the hashes of this build. Only for a change of the arithmetic
# that is meant; on a CPU with fused instructions.
set -euo pipefail

if [ "$1" = --update ]; then
  fused=$("$3")
  plain=$("$3" --target "scalar plain")
  [[ $fused == *" fused "* ]] || { echo "no fused kernel runs here: $fused"; exit 1; }
  {
    echo "# Hashes of everything that qtraj_golden samples: for each kind of arithmetic, whatever the CPU, the compiler"
    echo "# and its flags, that of the first methods and functions, and that of the methods and rules added since. After a"
    echo "# change that is meant: tests/golden/golden.sh --update FILE PROGRAM"
    echo "fused ${fused#* fused }"
    echo "plain ${plain#* plain }"
  } >"$2"
  cat "$2"
  exit
fi

expected=$1 program=$2
shift 2
status=0
result=$("$program" ${1:+--target "$1"}) || status=$?
echo "$result"
[ "$status" = 0 ] || exit "$status"
read -r target arithmetic hashes <<<"$result"
published=$(sed -n "s/^$arithmetic //p" "$expected")
[ -n "$published" ] || { echo "no hashes of $arithmetic arithmetic in $expected"; exit 1; }
if [ "$hashes" != "$published" ]; then
  echo "$target has other bits: published for $arithmetic arithmetic is $published"
  exit 1
fi
