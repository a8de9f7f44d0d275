#!/usr/bin/env bash
# quick.sh [ctest options]: the loop to work in. Builds the library in Release, warnings as errors, with its scalar code
# and the best vector kernel that this CPU runs, and runs the tests of the core and of the C functions: from nothing two
# minutes on two cores, after a change seconds. With options it runs what they choose instead: tests/quick.sh -R so3.
# The gate is tests/run.sh; what it has more is said at the end. Installs what is missing (Debian, Ubuntu); writes only
# to build/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/apt_packages.sh
need_packages cmake g++ ninja-build libeigen3-dev libhwy-dev catch2
use_ccache

features=" $(grep -m 1 -E '^(flags|Features)' /proc/cpuinfo 2>/dev/null || true) "
case "$(uname -m)" in
  x86_64) case "$features" in *" avx2 "*) target=avx2 ;; *) target=sse4 ;; esac ;;
  aarch64) target=neon ;;
  *) target=scalar ;;
esac

seconds_of() {
  local start=$SECONDS
  "${@:2}"
  times+=("$1 $((SECONDS - start)) s")
}
times=()
build_all() { cmake --build --preset quick --parallel "$(nproc)"; }
configure() { cmake --preset quick -DQTRAJ_TARGETS="$target" --log-level=NOTICE; }
run_tests() { ctest --preset quick --parallel "$(nproc)" --no-label-summary "$@"; }

[ $# -gt 0 ] || set -- --label-exclude long
seconds_of configure configure
seconds_of build build_all
seconds_of tests run_tests "$@"

cat <<END

Left to tests/run.sh: tests of two seconds and more (label long), every kernel but $target and scalar code, sanitizers,
SciPy, other compilers, and the labels forced, gates and package.
END
echo "quick.sh: $(IFS=,; echo "${times[*]}" | sed 's/,/, /g'), all $SECONDS s"
