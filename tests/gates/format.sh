#!/usr/bin/env bash
# format.sh root: all C and C++ files are laid out as .clang-format says. Version 14 decides, as others differ in details;
# where the system has none, tests/run.sh puts one into build/tools.
set -euo pipefail
cd "$1"
for tool in clang-format-14 clang-format build/tools/clang_format/data/bin/clang-format; do
  case "$("$tool" --version 2>/dev/null)" in *"version 14."*)
    find . '(' -path './build*' -o -path ./python/headers ')' -prune -o -type f -name '*.[ch]' -print0 -o -type f -name '*.[ch]pp' -print0 |
      xargs -0 "$tool" --dry-run -Werror
    exit ;;
  esac
done
echo "clang-format 14 is not installed"
exit 1
