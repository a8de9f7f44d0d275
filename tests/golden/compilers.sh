#!/usr/bin/env bash
# compilers.sh source build compiler flags [cmake options...]: the library and qtraj_golden, built in the folder `build`
# with that compiler and those flags, give the published hashes, for the kernel of this CPU and in plain arithmetic.
set -euo pipefail
source=$1 build=$2 compiler=$3 flags=$4
shift 4
command -v "$compiler" || { echo "$compiler is missing"; exit 1; }

mkdir -p "$build"
cmake -S "$source" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_CXX_FLAGS_RELEASE="$flags" -DQTRAJ_TEST_QUICK=ON "$@" >"$build/log" 2>&1 || { cat "$build/log"; exit 1; }
cmake --build "$build" --parallel 2 --target qtraj_golden >"$build/log" 2>&1 || { cat "$build/log"; exit 1; }

golden=$source/tests/golden
"$golden/golden.sh" "$golden/expected.txt" "$build/tests/golden/qtraj_golden"
"$golden/golden.sh" "$golden/expected.txt" "$build/tests/golden/qtraj_golden" "scalar plain"
