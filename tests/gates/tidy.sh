#!/usr/bin/env bash
# tidy.sh root build [all]: clang-tidy finds nothing, by .clang-tidy, in the source files below src/ and capi/ that
# differ from the commit before or are not committed, and in the headers of ours that they include; of a changed header
# the source file of its name is taken. Without a commit before, as in a tarball or a shallow clone, or with `all`, in
# all source files. Takes at most the 12 that were changed last, except with `all`, and says which. `build` has
# compile_commands.json.
set -euo pipefail
root=$(cd "$1" && pwd)
build=$(cd "$2" && pwd)
limit=12
for tool in clang-tidy python3; do
  command -v "$tool" >/dev/null || { echo "$tool is not installed"; exit 1; }
done
[ -e "$build/compile_commands.json" ] ||
  { echo "no $build/compile_commands.json: configure with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON"; exit 1; }
cd "$root"

git_here() { git -c safe.directory='*' "$@" 2>/dev/null; }
if [ "${3-}" = all ]; then
  echo "All source files:"
  limit=100000
elif [ "$(git_here rev-parse --show-toplevel)" = "$root" ] && git_here rev-parse -q --verify HEAD~1 >/dev/null; then
  echo "Source files that differ from the commit before:"
  changed=$({ git_here diff --name-only HEAD~1 -- src capi; git_here ls-files --others --exclude-standard -- src capi; })
else
  echo "No commit before this one, so all source files:"
fi
files=$({ [ -z "${changed+set}" ] && find src capi -name '*.cpp' || sed -n 's/\.[ch]pp$/.cpp/p' <<<"$changed"; } | sort -u |
  while read -r file; do [ ! -e "$file" ] || echo "$file"; done)
[ -n "$files" ] || { echo "none"; exit 0; }
count=$(wc -l <<<"$files")
files=$(xargs -d '\n' ls -t <<<"$files" | head -n "$limit")
echo "$files"
[ "$count" -le "$limit" ] || echo "and $((count - limit)) more, which were NOT CHECKED: only the $limit changed last are"

# One command for each file, though kernels have one for every target, and without what is GCC's own: its precompiled
# headers, and warnings, which are the compiler's to give.
database=$(mktemp -d)
trap 'rm -rf "$database"' EXIT
python3 - "$build/compile_commands.json" "$database/compile_commands.json" <<'END'
import json, shlex, sys

entries = {}
for entry in json.load(open(sys.argv[1], encoding="utf-8")):
    words = iter(shlex.split(entry["command"]))
    kept = []
    for word in words:
        if word == "-include":
            word = next(words)
            if "cmake_pch" not in word:
                kept += ["-include", word]
        elif not word.startswith(("-W", "-fno-tree-vectorize")) or word.startswith("-Wl,"):
            kept.append(word)
    entries.setdefault(entry["file"], {"directory": entry["directory"], "file": entry["file"], "arguments": kept})
json.dump(list(entries.values()), open(sys.argv[2], "w", encoding="utf-8"))
END

status=0
xargs -d '\n' -P "$(nproc)" -n 1 clang-tidy -p "$database" --quiet --warnings-as-errors='*' <<<"$files" \
  2>"$database/errors" || status=$?
# beside errors it counts there the warnings of other people's headers
grep -vE '^[0-9]+ warnings? (generated|treated)|^Suppressed |^Use -header-filter' "$database/errors" || true
[ "$status" = 0 ] && echo "nothing found"
exit "$status"
