#!/usr/bin/env bash
# The gate, and what continuous integration runs: builds and tests everything. The library in Release, once, for all
# tests that judge it as shipped, and once more with the address and undefined-behaviour sanitizers; then the Python
# package with the former. From nothing about 25 minutes on two cores; the loop to work in is tests/quick.sh. Compiles
# through ccache where there is one. Installs what is missing (Debian, Ubuntu; for the Python package, below build/, from
# PyPI); writes only to build/ beside this folder.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/apt_packages.sh

need_packages cmake g++ make ninja-build libeigen3-dev libhwy-dev catch2 pkg-config python3 python3-scipy \
  python3-venv python3-dev python3-mpmath binutils clang clang-tidy doxygen libbenchmark-dev libglm-dev libboost-dev
need_clang_format
use_ccache

parts=("$SECONDS s  packages")
part() {
  local start=$SECONDS
  "${@:2}"
  parts+=("$((SECONDS - start)) s  $1")
}
build() {
  cmake --preset "$1"
  cmake --build --preset "$1" --parallel "$(nproc)"
}
run_tests() { ctest --preset "$1" --parallel "$(nproc)" --output-log "$PWD/build/$1/ctest.log"; }
# CTest's closing lines, with the seconds of each label
summary() { sed -n '/^[0-9]*% tests passed/,$p' "build/$1/ctest.log"; }

for preset in asan-ubsan dev; do
  echo "== $preset"
  part "$preset, build" build "$preset"
  part "$preset, tests" run_tests "$preset"
done

echo "== Python package"
part "python package" tests/python.sh build/dev

echo "== asan-ubsan"
summary asan-ubsan
echo "== Parts"
printf '%s\n' "${parts[@]}" "$SECONDS s  all"
# The shipped library comes last: its summary closes the output.
echo "== dev"
summary dev
