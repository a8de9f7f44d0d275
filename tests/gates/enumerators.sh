#!/usr/bin/env bash
# enumerators.sh qtraj.h enum_values.c: every enumerator of the header is pinned to its value there.
set -euo pipefail
export LC_ALL=C
diff <(grep -oE 'QTRAJ_[A-Z0-9_]+ = ' "$1" | sed 's/ = //' | sort) \
  <(sed -n 's/^PIN(\(QTRAJ_[A-Z0-9_]*\),.*/\1/p' "$2" | grep -v '^QTRAJ_OPTIONS_BYTES$' | sort)
echo "all pinned"
