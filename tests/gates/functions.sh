#!/usr/bin/env bash
# functions.sh qtraj.h: the names of the functions it declares, sorted, one a line.
set -euo pipefail
names=$(sed -n 's/^QTRAJ_API .*[ *]\(qtraj_[a-z0-9_]*\)(.*/\1/p' "$1" | LC_ALL=C sort)
# a declaration written in another shape must not go unnoticed
if [ "$(grep -c '^ *QTRAJ_API' "$1")" -ne "$(wc -l <<<"$names")" ]; then
  echo "functions.sh: not every declaration was understood: begin each with 'QTRAJ_API type qtraj_name(' in one line" >&2
  exit 1
fi
echo "$names"
