#!/usr/bin/env bash
# A first look: builds the library, installs it below build/, builds lesson 1 as a program of its own against it, and
# samples the recorded attitude of a spacecraft. Installs what is missing (Debian, Ubuntu); writes only to build/ beside
# this folder. QTRAJ_CMAKE_ARGS, if set, is passed to CMake: "-DQTRAJ_TARGETS=scalar" builds in a third of the time.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/apt_packages.sh
unset DESTDIR PKG_CONFIG_LIBDIR PKG_CONFIG_SYSROOT_DIR

# relative paths: the compiler flags of pkg-config shall hold no blank
out=build/quickstart
cores=$(nproc)
if [ -e $out/prefix/include/qtraj.h ]; then
  echo "== This takes some seconds: the library was built before, in $out"
else
  echo "== This takes about $((100 / cores + 10)) s on the $cores cores of this machine, and what packages take that are missing"
fi
need_packages cmake g++ make libeigen3-dev libhwy-dev pkg-config

echo
echo "== The library, built in Release, without its tests, and installed in $out/prefix"
cmake -S . -B $out/library -G "Unix Makefiles" -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_LIBDIR=lib \
  -DQTRAJ_BUILD_TESTS=OFF ${QTRAJ_CMAKE_ARGS-}
cmake --build $out/library --parallel "$cores"
cmake --install $out/library --prefix $out/prefix

export PKG_CONFIG_PATH=$out/prefix/lib/pkgconfig
export LD_LIBRARY_PATH=$PWD/$out/prefix/lib
show_and_run() { echo "\$ $*" && "$@"; }

echo
echo "== Lesson 1, built against the installed library"
show_and_run "${CC:-cc}" -std=c99 -O2 examples/01_sample_recording.c examples/lesson.c -o $out/01_sample_recording \
  $(pkg-config --cflags --libs qtraj) -lm

echo
echo "== The attitude of Cassini, body to inertial axes, sampled once a second from telemetry of every 4 s"
show_and_run $out/01_sample_recording examples/data/cassini_turn.csv rotation_spline 1 $out/cassini_attitude.csv \
  --conjugate

echo
echo "== Its first turn, of these samples: at rest, then 17 degrees every 200 s. w goes on through 0 at 2800 s, where the"
echo "   recording changes the sign of its quaternions"
echo "   time       w       x       y       z    turned by"
awk -F, 'NR == 2 { for (k = 2; k <= 5; ++k) first[k] = $k }
  NR > 1 && $1 >= 1600 && $1 <= 3000 && $1 % 200 == 0 {
    difference = sum = 0
    for (k = 2; k <= 5; ++k) { difference += ($k - first[k]) ^ 2; sum += ($k + first[k]) ^ 2 }
    least = difference < sum ? difference : sum
    printf "%5d s  %6.3f  %6.3f  %6.3f  %6.3f    %5.1f degrees\n", $1, $2, $3, $4, $5,
      4 * atan2(sqrt(least), sqrt(difference + sum - least)) * 57.29578
  }' $out/cassini_attitude.csv
echo "   All samples: $out/cassini_attitude.csv"

cat <<END

== What next, in $PWD
   Programs of your own, README.md has a first one:
     export PKG_CONFIG_PATH="\$PWD/$out/prefix/lib/pkgconfig" LD_LIBRARY_PATH="\$PWD/$out/prefix/lib"
     cc app.c \$(pkg-config --cflags --libs qtraj) -o app
   The other lessons, after the same export; each file ends with what it prints:
     make -C examples
     cd examples && ./06_settings data/cassini_turn.csv 40 --conjugate
   The table "Your job" in README.md tells which lesson and which function is for what; docs/ has the rest.
END
