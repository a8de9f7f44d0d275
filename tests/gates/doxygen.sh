#!/usr/bin/env bash
# doxygen.sh root output: qtraj.h is its own manual. Every function, also each float twin, has a comment directly before
# it, every constant has one, doxygen makes HTML and man pages of them in `output` without a warning, and none of the
# functions is missing there.
set -euo pipefail
export LC_ALL=C
gates=$(cd "$(dirname "$0")" && pwd)
mkdir -p "${2:?}"
output=$(cd "$2" && pwd)
cd "$1"
header=include/qtraj.h
functions=$("$gates/functions.sh" "$header")
command -v doxygen >/dev/null || { echo "doxygen is not installed"; exit 1; }

# An editor shows the comment that ends in the line before the declaration; doxygen 1.9 is silent on enumerators.
awk '
  function fail(message) { print FILENAME ":" FNR ": " message; bad = 1 }
  /^ *\/\*\*( |$)/ { comment = "" }
  { if (in_comment || /^ *\/\*\*( |$)/) { comment = comment $0 "\n"; in_comment = 1 } }
  /^QTRAJ_API / {
    name = $0
    sub(/\(.*/, "", name)
    sub(/.*[ *]/, "", name)
    if (ended != FNR - 1) fail(name " has no comment of its own")
    else if (comment !~ /@return|@param/) fail(name ": neither arguments nor result in the comment")
    else if (name ~ /_f32$/ && index(comment, "twin of " substr(name, 1, length(name) - 4) "()") == 0)
      fail(name " does not say whose twin it is")
  }
  /^ *QTRAJ_[A-Z0-9_]+ = / && !/\/\*\*< / && ended != FNR - 1 { fail($1 " has no comment") }
  in_comment && /\*\/$/ { in_comment = 0; ended = FNR }
  END { exit bad }' "$header"

# pages of the last run, of functions that are gone, would hide what is missing
rm -rf "$output/html" "$output/man"
{ cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = \"$output\""; } | doxygen -

for function in $functions; do
  [ -e "$output/man/man3/$function.3" ] || { echo "no man page of $function"; exit 1; }
  grep -qE ">$function\(\)</(h2|a|td)" "$output"/html/group__*.html || { echo "not in the HTML: $function"; exit 1; }
done
echo "$(wc -l <<<"$functions") functions"
