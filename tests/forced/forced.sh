#!/usr/bin/env bash
# forced.sh folder target program arguments...: runs a program with the library of that folder in place of its own, the
# kernel forced to the target. Exits with 77 (skipped, with a line that says so) where this CPU cannot run it.
set -euo pipefail
folder=$1 target=$2
shift 2
export LD_LIBRARY_PATH=$folder QTRAJ_TEST_TARGET=$target
status=0
output=$("$@" 2>&1) || status=$?
echo "$output"
if grep -qxF "cannot run: $target" <<<"$output"; then
  echo "NOT RUN: this CPU has no kernel \"$target\""
  exit 77
fi
if ! grep -qxF "forced: $target" <<<"$output"; then
  echo "the program did not load the library of $folder"
  exit 1
fi
# not the program's own status, which counts failures and may be 77
[ "$status" = 0 ] || exit 1
