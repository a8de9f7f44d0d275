#!/usr/bin/env bash
# exports.sh qtraj.h libqtraj.so: the library exports the functions of the header, all with the node QTRAJ_0, and nothing
# else.
set -euo pipefail
export LC_ALL=C
functions=$("$(dirname "$0")/functions.sh" "$1")

# the node itself is listed as an absolute symbol
exported=$(nm -D --defined-only --with-symbol-versions "$2" | awk '!($2 == "A" && $3 == "QTRAJ_0") {print $3}' | sort)
diff <(sed 's/$/@@QTRAJ_0/' <<<"$functions") <(echo "$exported")
echo "the same"
