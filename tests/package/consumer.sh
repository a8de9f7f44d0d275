#!/usr/bin/env bash
# consumer.sh name: builds one outside project against the installed and moved library, and runs it. From the
# environment: CC, CXX, CMAKE, GENERATOR; FOLDER with the installed tree in prefix/; LIBDIR, lib or the like;
# SOURCE, the root of this project; EIGEN, the folder of the Eigen headers.
set -euo pipefail
export CC CXX
here=$SOURCE/tests/package
prefix=$FOLDER/prefix
libdir=$prefix/$LIBDIR
export PKG_CONFIG_PATH=$libdir/pkgconfig
unset PKG_CONFIG_LIBDIR PKG_CONFIG_SYSROOT_DIR LD_LIBRARY_PATH CFLAGS CXXFLAGS LDFLAGS

work=$FOLDER/$1
rm -rf "$work"
mkdir -p "$work"
cd "$work"

fail() { echo "$*"; exit 1; }

# needs program pattern: whether one of the libraries that the program loads matches
needs() { [ -n "$(readelf -dW "$1" | sed -n '/(NEEDED)/p' | grep -E "$2")" ]; }

# find_package prefix language target arguments: configures, builds and runs the project find_package/
find_package() {
  rm -rf build
  "$CMAKE" -G "$GENERATOR" -S "$here/find_package" -B build -DCMAKE_PREFIX_PATH="$1" -DLANGUAGE="$2" -DTARGET="$3" \
    -DFIND_ARGS="$4" -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF &&
    "$CMAKE" --build build --target run
}

# refused prefix arguments text: find_package stops with that text
refused() {
  local said
  if said=$(find_package "$1" C qtraj::qtraj "$2" 2>&1); then fail "find_package(qtraj $2) was not refused"; fi
  grep -qF "$3" <<<"$said" || fail "find_package(qtraj $2) was refused, but without '$3': $said"
}

case $1 in
  pkgconfig_shared)
    $CC -std=c99 "$here/slerp.c" -o slerp $(pkg-config --cflags --libs qtraj) -lm
    LD_LIBRARY_PATH=$libdir ./slerp
    needs slerp 'libqtraj\.so\.0' || fail "was not linked with the shared library"
    ;;

  pkgconfig_static)
    $CC -std=c99 -static "$here/slerp.c" -o slerp $(pkg-config --static --cflags --libs qtraj)
    ./slerp
    # the same with a shared C library; a compiler for C is all it takes
    $CC -std=c99 "$here/slerp.c" -o slerp $(pkg-config --static --cflags qtraj) "$libdir/libqtraj.a" -lm
    ./slerp
    if needs slerp 'libqtraj|libstdc\+\+|libc\+\+'; then fail "needs a library it should not need"; fi
    ;;

  preinit)
    $CC -std=c99 -static "$here/preinit.c" -o preinit $(pkg-config --static --cflags --libs qtraj)
    early=$(./preinit early)
    late=$(./preinit)
    [ "$early" = "$late" ] || fail "'$early' before constructors, '$late' after them"
    ;;

  pkgconfig_version)
    cat >version.c <<'END'
#include <qtraj.h>
#include <stdio.h>
int main(void) {
  printf("%s %s %d.%d.%d %d\n", qtraj_version(), QTRAJ_VERSION_STRING, QTRAJ_VERSION_MAJOR, QTRAJ_VERSION_MINOR,
         QTRAJ_VERSION_PATCH, qtraj_version_number() == QTRAJ_VERSION_NUMBER);
  return 0;
}
END
    $CC version.c -o version $(pkg-config --cflags --libs qtraj)
    version=$(pkg-config --modversion qtraj)
    printed=$(LD_LIBRARY_PATH=$libdir ./version)
    [ "$printed" = "$version $version $version 1" ] || fail "the package says $version, the library $printed"
    [ -f "$libdir/libqtraj.so.$version" ] || fail "no libqtraj.so.$version"
    ;;

  cmake_c_shared)
    find_package "$prefix" C qtraj::qtraj 0.1
    needs build/consumer 'libqtraj\.so\.0' || fail "qtraj::qtraj is not the shared library"
    find_package "$prefix" C qtraj::shared '0.1;COMPONENTS;shared'
    ;;

  cmake_c_static)
    find_package "$prefix" C qtraj::static '0.1;COMPONENTS;static'
    if needs build/consumer 'libqtraj|libstdc\+\+|libc\+\+'; then fail "needs a library it should not need"; fi
    ;;

  cmake_cxx)
    find_package "$prefix" CXX qtraj::qtraj 0.1
    find_package "$prefix" CXX qtraj::static 0.1
    ;;

  cmake_components)
    refused "$prefix" 'COMPONENTS;dynamic' "component 'dynamic' is not installed"
    refused "$prefix" '0.2' 'version'
    refused "$prefix" '1.0' 'version'

    # packages split in two: each half works alone
    cp -a "$prefix" only_static
    rm only_static/"$LIBDIR"/libqtraj.so* only_static/"$LIBDIR"/cmake/qtraj/qtraj-shared-targets*
    find_package "$work/only_static" C qtraj::qtraj '0.1'
    if needs build/consumer libqtraj; then fail "qtraj::qtraj is not the static library"; fi
    refused "$work/only_static" 'COMPONENTS;shared' "component 'shared' is not installed"

    cp -a "$prefix" only_shared
    rm only_shared/"$LIBDIR"/libqtraj.a only_shared/"$LIBDIR"/cmake/qtraj/qtraj-static-targets*
    find_package "$work/only_shared" C qtraj::qtraj '0.1;COMPONENTS;shared;OPTIONAL_COMPONENTS;static'
    refused "$work/only_shared" 'COMPONENTS;static' "component 'static' is not installed"
    ;;

  subproject)
    # without vector kernels, which take the compiler longest: it is about the CMake code
    "$CMAKE" -G "$GENERATOR" -S "$here/subproject" -B build -DQTRAJ_SOURCE="$SOURCE" -DQTRAJ_TARGETS=scalar
    "$CMAKE" --build build --parallel 2
    "$CMAKE" --build build --target run
    "$CMAKE" --install build --prefix installed
    installed=$(cd installed && find . ! -type d)
    [ "$installed" = ./bin/with_shared ] || fail "the parent's install installed:" $installed
    ;;

  cxx17)
    $CXX -std=c++17 "$here/slerp.cpp" -o slerp $(pkg-config --cflags --libs qtraj)
    LD_LIBRARY_PATH=$libdir ./slerp
    ;;

  eigen)
    $CXX -std=c++17 -O0 -isystem "$EIGEN" $(pkg-config --static --cflags qtraj) -c "$here/with_eigen.cpp"
    # whichever comes first, the program's objects or the library's
    $CXX with_eigen.o "$libdir/libqtraj.a" -lm -o program_first
    ./program_first
    $CXX -Wl,--whole-archive "$libdir/libqtraj.a" -Wl,--no-whole-archive with_eigen.o -lm -o library_first
    ./library_first
    ;;

  python)
    python3 -B "$here/slerp.py" "$libdir/libqtraj.so.0"
    ;;

  *)
    fail "no consumer named $1"
    ;;
esac
