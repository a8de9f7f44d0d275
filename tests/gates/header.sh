#!/usr/bin/env bash
# header.sh qtraj.h cc c++: a file that includes only qtraj.h compiles without a warning in every standard.
set -euo pipefail
folder=$(dirname "$1")
cc=$2
cxx=$3
for compiler in "$cc" "$cxx"; do
  command -v "$compiler" >/dev/null || { echo "$compiler is not installed"; exit 1; }
done
warnings="-pedantic -Wall -Wextra -Wconversion -Wundef -Wshadow -Werror"

use='#include "qtraj.h"
#if QTRAJ_VERSION_NUMBER < 1
#error
#endif
int main(void) { return qtraj_version_number() == QTRAJ_VERSION_NUMBER ? QTRAJ_OK : QTRAJ_E_INTERNAL; }'

for standard in c99 c11 c17; do
  echo "$cc -std=$standard"
  "$cc" -x c -std=$standard $warnings -Wstrict-prototypes -fsyntax-only -I "$folder" - <<<"$use"
done
for standard in c++98 c++11 c++14 c++17 c++20; do
  echo "$cxx -std=$standard"
  "$cxx" -x c++ -std=$standard $warnings -fsyntax-only -I "$folder" - <<<"$use"
done

# A status that is ignored is a warning, unless it is cast to void or QTRAJ_NODISCARD is defined as nothing.
ignore='#include "qtraj.h"
void ignore(qtraj_options* options);
void ignore(qtraj_options* options) { CAST qtraj_options_set_tangents(options, QTRAJ_TANGENT_DEFAULT); }'
accepts() { "$@" $warnings -fsyntax-only -I "$folder" - <<<"$ignore" 2>/dev/null; }
for compile in "$cc -x c -std=c99" "$cc -x c -std=c17" "$cxx -x c++ -std=c++11" "$cxx -x c++ -std=c++17"; do
  echo "$compile, status ignored"
  if accepts $compile -DCAST=; then echo "no warning"; exit 1; fi
  accepts $compile "-DCAST=(void)" && accepts $compile -DCAST= -DQTRAJ_NODISCARD=
done
