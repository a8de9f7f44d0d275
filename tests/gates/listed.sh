#!/usr/bin/env bash
# listed.sh tests: every test file is in the lists of tests/CMakeLists.txt, so that none is left out unnoticed.
set -euo pipefail
cd "$1"
status=0
for file in unit/test_*.cpp capi/test_*.cpp reference/test_*.cpp; do
  if ! grep -qw "$(basename "$file")" CMakeLists.txt; then
    echo "tests/$file is not listed in tests/CMakeLists.txt"
    status=1
  fi
done
exit $status
