#!/usr/bin/env bash
# The gate, and what continuous integration runs: builds and tests everything. The library in Release, once, for all
# tests that judge it as shipped, and once more with the address and undefined-behaviour sanitizers. From nothing at most
# 15 minutes on two cores; the loop to work in is tests/quick.sh. Compiles through ccache where there is one. Installs
# what is missing (Debian, Ubuntu); writes only to build/ beside this folder.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/apt_packages.sh

need_packages cmake g++ make ninja-build libeigen3-dev libhwy-dev catch2 pkg-config python3 python3-scipy \
  python3-mpmath binutils clang clang-tidy doxygen libbenchmark-dev libglm-dev libboost-dev
need_clang_format
use_ccache

times=("packages $SECONDS s")
timed() {
  local start=$SECONDS
  "${@:2}"
  times+=("$1 $((SECONDS - start)) s")
}
build() {
  cmake --preset "$1"
  cmake --build --preset "$1" --parallel "$(nproc)"
}
# seconds of each label are in its summary
run_tests() {
  echo "== $1"
  ctest --preset "$1" --parallel "$(nproc)" --output-log "build/$1/ctest.log"
}

timed "sanitizers: build" build asan-ubsan
timed "tests" run_tests asan-ubsan
timed "as shipped: build" build dev
# The shipped library comes last, so that its summary closes the output.
timed "tests" run_tests dev
