#!/usr/bin/env bash
# methods.sh root: every method of the header has its row in the table of methods, in the tests' settings and in
# docs/methods.md, and those name no other.
set -euo pipefail
export LC_ALL=C
cd "$1"
methods=$(sed -n '/^enum qtraj_method_value {/,/^}/p' include/qtraj.h | grep -oE 'QTRAJ_[A-Z_]+ =' | sed 's/ =//' | sort)
[ "$(wc -l <<<"$methods")" -ge 8 ] || { echo "methods.sh: the header's methods were not found"; exit 1; }

compare() {
  echo "the header against $1:"
  diff <(echo "$methods") <(sort -u)
}
compare src/methods/method.cpp < <(grep -oE '^    \{Method\{QTRAJ_[A-Z_]+' src/methods/method.cpp |
  grep -oE 'QTRAJ_[A-Z_]+' | grep -v '^QTRAJ_VECTOR_')
compare tests/support/method_settings.hpp < \
  <(grep -oE '\{"[A-Z_]+", QTRAJ_[A-Z_]+' tests/support/method_settings.hpp | grep -oE 'QTRAJ_[A-Z_]+')
compare docs/methods.md < <(grep -oE '^\| `QTRAJ_[A-Z_]+` \|' docs/methods.md | grep -oE 'QTRAJ_[A-Z_]+')
echo "the same"
