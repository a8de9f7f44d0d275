#!/usr/bin/env bash
# exports.sh qtraj.h qtraj.map libqtraj.so: the library exports the functions of the header, all with the node QTRAJ_0,
# and nothing else; the export list names the same functions.
set -euo pipefail
export LC_ALL=C
functions=$("$(dirname "$0")/functions.sh" "$1")

echo "the header against the export list:"
diff <(echo "$functions") <(sed -n 's/^ *\(qtraj_[a-z0-9_]*\);$/\1/p' "$2" | sort)

echo "the header against the library:"
# the node itself is listed as an absolute symbol
exported=$(nm -D --defined-only --with-symbol-versions "$3" | awk '!($2 == "A" && $3 == "QTRAJ_0") {print $3}' | sort)
diff <(sed 's/$/@@QTRAJ_0/' <<<"$functions") <(echo "$exported")
echo "the same"
