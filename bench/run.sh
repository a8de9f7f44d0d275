#!/usr/bin/env bash
# run.sh [--large]: builds and runs all benchmarks and writes results.md beside this file. --large: M = 1e8 too, which
# needs 4 GB. Installs what is missing (Debian, Ubuntu). Other work on the machine changes the results.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/apt_packages.sh

large=()
case "${1-}" in
  '') ;;
  --large) large=(--large) ;;
  *) echo "usage: bench/run.sh [--large]" >&2; exit 1 ;;
esac

need_packages cmake g++ ninja-build libeigen3-dev libhwy-dev libbenchmark-dev libglm-dev libboost-dev python3 \
  python3-venv

build=build/benchmarks
python=$build/python/bin/python
[ -x "$python" ] || python3 -m venv $build/python
"$python" -m pip install --quiet numpy scipy numpy-quaternion
cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DQTRAJ_BUILD_TESTS=OFF -DQTRAJ_INSTALL=OFF \
  -DQTRAJ_BUILD_BENCH=ON
cmake --build $build --target qtraj_bench_program

# The kernel of this CPU does everything; other fused ones the rows that have a target; plain ones the headline.
headline='^(slerp|squad)_f../sorted/warm/K:1000/M:1000000/'
aimed="$headline|^slerp_f64/(sorted/warm/K:1000/M:(100000|10000000)|random/warm/K:1000/M:1000000)/"
aimed+='|^rows_|^sample_at|^batch_|^vector_|^init_|^create_rotation_spline|^rig_|^columns_from_rows|^(slerp_pairs|mean_eigen|karcher_step).*/M:1000000/'
mapfile -t targets < <("$build/bench/qtraj_bench" --list-targets)
results=()
for target in "${targets[@]}"; do
  name=$build/${target// /_}
  case "$target" in
    "${targets[0]}") options=("${large[@]}") ;;
    *fused) options=("--benchmark_filter=$aimed") ;;
    *) options=("--benchmark_filter=$headline") ;;
  esac
  echo "== $target"
  "$build/bench/qtraj_bench" --target="$target" "${options[@]}" --benchmark_repetitions=5 --benchmark_min_time=0.01 \
    --benchmark_enable_random_interleaving=true --benchmark_out="$name.json" --benchmark_out_format=json \
    --benchmark_display_aggregates_only=true >"$name.log"
  results+=("$name.json")
  # fused kernels have targets against SciPy
  case "$target" in *fused)
    "$python" -I bench/scipy_peers.py "$build/bench/libqtraj_bench.so" "$target" "${name}_scipy.json"
    results+=("${name}_scipy.json") ;;
  esac
done
"$python" -I bench/report.py bench/results.md "${results[@]}"
echo "Wrote bench/results.md"
