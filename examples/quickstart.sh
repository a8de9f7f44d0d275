#!/usr/bin/env bash
# A first look: builds the library, installs it below build/, builds lesson 1 as a program of its own against it, and
# samples the recorded attitude of a spacecraft. Installs what is missing (Debian, Ubuntu); writes only to build/ beside
# this folder.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/apt_packages.sh
unset DESTDIR PKG_CONFIG_LIBDIR PKG_CONFIG_SYSROOT_DIR

need_packages cmake g++ make libeigen3-dev libhwy-dev pkg-config

# relative paths: the compiler flags of pkg-config shall hold no blank
out=build/quickstart
cmake -S . -B $out/library -G "Unix Makefiles" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_LIBDIR=lib \
  -DQTRAJ_BUILD_TESTS=OFF
cmake --build $out/library --parallel "$(nproc)"
cmake --install $out/library --prefix $out/prefix

export PKG_CONFIG_PATH=$out/prefix/lib/pkgconfig
export LD_LIBRARY_PATH=$PWD/$out/prefix/lib
show_and_run() { echo "\$ $*" && "$@"; }

echo
echo "== Lesson 1, built against the installed library"
show_and_run "${CC:-cc}" -std=c99 -O2 examples/01_sample_recording.c examples/lesson.c -o $out/01_sample_recording \
  $(pkg-config --cflags --libs qtraj) -lm

echo
echo "== The attitude of Cassini, body to inertial axes, sampled once a second: half an hour at rest, then it turns"
show_and_run $out/01_sample_recording examples/data/cassini_turn.csv squad 1 $out/cassini_attitude.csv

echo
echo "== First samples of $PWD/$out/cassini_attitude.csv"
head -n 6 $out/cassini_attitude.csv
