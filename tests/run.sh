#!/usr/bin/env bash
# Builds and tests everything: the library in Release with warnings as errors, then with the address and
# undefined-behaviour sanitizers. Installs what is missing (Debian, Ubuntu); writes only to build/ beside this folder.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/apt_packages.sh

need_packages cmake g++ make ninja-build libeigen3-dev libhwy-dev catch2 pkg-config python3 python3-scipy \
  binutils clang clang-format-14 libbenchmark-dev libglm-dev libboost-dev

for preset in dev asan-ubsan; do
  cmake --preset "$preset"
  cmake --build --preset "$preset"
done

# The shipped library comes last, so that its summary closes the output.
for preset in asan-ubsan dev; do
  echo "== $preset"
  ctest --preset "$preset" --parallel "$(nproc)" --no-label-summary
done
