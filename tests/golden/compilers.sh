#!/usr/bin/env bash
# compilers.sh source compiler flags [cmake options...]: the library and qtraj_golden, built with that compiler and those
# flags, give the published hashes, for the kernel of this CPU and in plain arithmetic.
set -euo pipefail
source=$1 compiler=$2 flags=$3
shift 3
command -v "$compiler" || { echo "$compiler is missing"; exit 1; }
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT

cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_CXX_FLAGS_RELEASE="$flags" "$@" >"$build/log" || { cat "$build/log"; exit 1; }
cmake --build "$build" --target qtraj_golden >"$build/log" || { cat "$build/log"; exit 1; }

golden=$source/tests/golden
"$golden/golden.sh" "$golden/expected.txt" "$build/tests/golden/qtraj_golden"
"$golden/golden.sh" "$golden/expected.txt" "$build/tests/golden/qtraj_golden" "scalar plain"
