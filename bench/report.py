#!/usr/bin/env python3
"""report.py out.md results.json...: the table of ratios from what the benchmarks and scipy_peers.py measured.

Each JSON file is one process: Google Benchmark's output with repetitions, or the same form from scipy_peers.py. Ours
and the peer of a row come from one process; the ratio is that of their medians.
"""
import json
import statistics
import sys
from collections import defaultdict, namedtuple

Row = namedtuple("Row", "work order memory keys samples")

# What the project aims at: the row, the peer, how many times faster on AVX-512 and on AVX2.
AT_LEAST = [
    (Row("slerp_f64", "sorted", "warm", 1000, 10**6), "eigen", 15, 12),
    (Row("slerp_f32", "sorted", "warm", 1000, 10**6), "eigen", 20, 15),
    (Row("slerp_f64", "sorted", "warm", 1000, 10**5), "eigen", 30, 18),
    (Row("slerp_f64", "random", "warm", 1000, 10**6), "eigen", 15, 10),
    (Row("squad_f64", "sorted", "warm", 1000, 10**6), "glm", 20, 11),
    (Row("squad_f32", "sorted", "warm", 1000, 10**6), "glm", 35, 18),
    (Row("log_spline_f64", "sorted", "warm", 1000, 10**6), "scipy", 120, 80),
    (Row("rotation_spline_f64", "sorted", "warm", 1000, 10**6), "scipy", 120, 80),
    (Row("log_spline_q_omega_f64", "sorted", "warm", 1000, 10**6), "scipy", 200, 120),
    (Row("rotation_spline_q_omega_f64", "sorted", "warm", 1000, 10**6), "scipy", 200, 120),
    (Row("slerp_pairs_f64", "sorted", "warm", 0, 10**6), "numpy_quaternion", 15, 15),
    (Row("slerp_pairs_f64", "sorted", "warm", 0, 10**6), "eigen", 6, 6),
    (Row("sample_at_f64", "sorted", "warm", 1000, 10**4), "eigen", 1.8, 1.8),
    (Row("mean_eigen_f64", "sorted", "warm", 0, 10**6), "scipy", 20, 20),
    (Row("karcher_step_f64", "sorted", "warm", 0, 10**6), "atan2", 15, 15),
    (Row("create_rotation_spline_f64", "sorted", "warm", 1000, 0), "scipy", 20, 20),
    (Row("vector_cubic_f64", "sorted", "warm", 1000, 10**6), "scipy", 10, 10),
    (Row("vector_cubic_f64", "sorted", "warm", 1000, 10**6), "loop", 1, 1),
    (Row("vector_sample_at_f64", "sorted", "warm", 1000, 10**4), "loop", 0.5, 0.5),
    (Row("rig_slerp_f64", "sorted", "warm", 25, 20), "calls", 5, 5),
    (Row("rig_squad_f64", "sorted", "warm", 25, 20), "calls", 4, 3),
    (Row("rig_rotation_spline_f64", "sorted", "warm", 25, 20), "calls", 4, 3),
    (Row("rig_rates_rotation_spline_f64", "sorted", "warm", 25, 20), "cursors", 4, 3),
    (Row("rig_slerp_f64", "sorted", "warm", 25, 200000), "calls", 1, 1),
    (Row("rig_rotation_spline_f64", "sorted", "warm", 25, 200000), "calls", 1, 1),
    (Row("rig_by_time_slerp_f64", "sorted", "warm", 25, 200000), "calls", 1, 1),
    (Row("rig_by_time_rotation_spline_f64", "sorted", "warm", 25, 200000), "calls", 1, 1),
    # past the first cache: two arrays of 24 kB fill one of 48 kB, and memcpy's time there is that of the pages' places
    (Row("rows_from_columns_3_f64", "sorted", "warm", 0, 10**4), "memcpy", 1 / 1.5, 1 / 1.5),
    (Row("rows_from_columns_4_f64", "sorted", "warm", 0, 10**4), "memcpy", 1 / 1.5, 1 / 1.5),
    (Row("columns_from_rows_4_f64", "sorted", "warm", 0, 1000), "loop", 1.5, 1.5),
]
# Few keys, in reused memory: the peer prepares slerp and nothing else.
AT_LEAST += [
    (Row("init_slerp_f64", "sorted", "warm", 16, 0), "eigen", 0.9, 0.55),
    (Row("init_nlerp_f64", "sorted", "warm", 16, 0), "eigen", 1.2, 1.0),
    (Row("init_squad_f64", "sorted", "warm", 64, 0), "eigen", 0.45, 0.25),
    (Row("init_hermite_f64", "sorted", "warm", 64, 0), "eigen", 0.75, 0.5),
]
# Ratios to memory alone: at least 1 / (how many times its time).
AT_LEAST += [
    (Row("slerp_f64", "sorted", "warm", 1000, 10**6), "bytes", 1 / 2, 1 / 2),
    (Row("slerp_f64", "sorted", "warm", 1000, 10**7), "bytes", 1 / 1.3, 1 / 1.3),
]
# Many curves in one call: at most 1.1 times a loop over them, and 1.2 times the sampling of curves that are there.
AT_LEAST += [
    (Row("batch_ragged_slerp_f64", "sorted", "warm", 12, 2 * 10**6), "loop", 1 / 1.1, 1 / 1.1),
    (Row("batch_ragged_rotation_spline_f64", "sorted", "warm", 12, 2 * 10**6), "loop", 1 / 1.1, 1 / 1.1),
    (Row("batch_slerp_f64", "sorted", "warm", 16, 2 * 10**6), "sampling", 1 / 1.2, 1 / 1.2),
]
# Functions over rows, in the caches: at the speed of memory, or so many times as fast as a loop over the C library, and
# past them so many times as fast as SciPy.
AT_LEAST += [(Row(f"rows_{name}_f64", "sorted", "warm", 0, 1000), "bytes", 1 / 1.5, 1 / 1.5)
             for name in ("multiply", "conjugate", "norm", "dot", "wxyz_from_xyzw", "xyzw_from_wxyz", "rotate")]
AT_LEAST += [(Row(f"rows_{name}_f64", "sorted", "warm", 0, 1000), "loop", 6, 4)
             for name in ("exp", "log", "pow", "q_from_rotation_vector", "rotation_vector_from_q", "distance")]
AT_LEAST += [(Row(f"rows_{name}_f64", "sorted", "warm", 0, 1000), "loop", 3, 3)
             for name in ("matrix_from_q", "q_from_matrix")]
AT_LEAST += [(Row(f"rows_{name}_f64", "sorted", "warm", 0, 10**6), "scipy", 20, 20)
             for name in ("multiply", "conjugate", "inverse", "rotate", "pow", "q_from_rotation_vector",
                          "rotation_vector_from_q", "matrix_from_q", "q_from_matrix", "rotation_angle")]
# At most so many ns.
LATENCY = (Row("sample_at_f64", "sorted", "warm", 1000, 10**4), 25)
# Time per unit of the first over that of the second, at most.
GROWTH = [
    ("construction per key, K = 1e6 over 1e4", Row("create_rotation_spline_f64", "sorted", "warm", 10**6, 0),
     Row("create_rotation_spline_f64", "sorted", "warm", 10**4, 0), 3),
    ("SLERP, random over sorted times", Row("slerp_f64", "random", "warm", 1000, 10**6),
     Row("slerp_f64", "sorted", "warm", 1000, 10**6), 6),
]
NS_PER = {"ns": 1.0, "us": 1e3, "ms": 1e6, "s": 1e9}


class Process:
    """One JSON file: medians in ns per sample, by row and by who; or another summary of the repetitions."""

    def __init__(self, path, summary=statistics.median):
        with open(path, encoding="utf-8") as file:
            results = json.load(file)
        self.context = results["context"]
        self.target = self.context["qtraj_target"]
        runs = defaultdict(list)
        for run in results["benchmarks"]:
            if run.get("error_occurred"):
                sys.exit(f"report: {path}: {run['name']}: {run['error_message']}")
            if run["run_type"] == "iteration":
                runs[run["run_name"].removesuffix("/manual_time")].append(self.ns_per_sample(run))
        self.medians = defaultdict(dict)
        for name, values in sorted(runs.items()):  # interleaved repetitions come in any order
            work, order, memory, keys, samples, who = name.split("/")
            row = Row(work, order, memory, int(keys[2:]), int(samples[2:]))
            self.medians[row][who] = summary(values)

    @staticmethod
    def ns_per_sample(run):
        time = run["real_time" if run.get("manual") else "cpu_time"]
        return time * NS_PER[run["time_unit"]] / run["samples"]

    def target_ratio(self, row, who):
        for aimed_row, peer, avx512, avx2 in AT_LEAST:
            if (aimed_row, peer) == (row, who):
                return {"avx512 fused": avx512, "avx2 fused": avx2}.get(self.target)
        return None


def power(count):
    if count == 0:
        return "-"
    exponent = len(str(count)) - 1
    return f"1e{exponent}" if count == 10**exponent else str(count)


def cells(*values):
    return "| " + " | ".join(str(value) for value in values) + " |\n"


def work_text(row):
    extra = [word for word in (row.order, row.memory) if word not in ("sorted", "warm")]
    return " ".join([row.work] + extra)


def verdict(ratio, target):
    return "" if target is None else "yes" if ratio >= target else "**no**"


def ratio_rows(processes, aimed):
    """Rows that have a target, or those that have none."""
    for process in processes:
        for row, medians in process.medians.items():
            for who, peer in medians.items():
                target = process.target_ratio(row, who)
                if who == "ours" or (target is not None) != aimed:
                    continue
                if "ours" not in medians:
                    sys.exit(f"report: {row} has no row of ours")
                ratio = peer / medians["ours"]
                yield cells(work_text(row), power(row.keys), power(row.samples), process.target, who,
                            f"{medians['ours']:.2f}", f"{peer:.2f}", f"**{ratio:.2f}**",
                            *([f"{target:.2f}", verdict(ratio, target)] if aimed else []))


def write_ratios(out, processes):
    heads = ("work", "K", "M", "instruction set", "peer", "ours, ns", "peer, ns", "ratio")
    out.write("## Ratios that have a target\n\n")
    out.write(cells(*heads, "target", "reached") + "|---" * 10 + "|\n")
    out.writelines(ratio_rows(processes, True))
    out.write("\n## Limits\n\n" + cells("what", "instruction set", "measured", "at most", "reached") + "|---" * 5 + "|\n")
    for process in processes:
        latency = process.medians.get(LATENCY[0], {}).get("ours")
        if latency is not None:
            out.write(cells("sample_at, latency, ns", process.target, f"{latency:.1f}", LATENCY[1],
                            verdict(-latency, -LATENCY[1])))
        for text, grown, base, limit in GROWTH:
            pair = [process.medians.get(row, {}).get("ours") for row in (grown, base)]
            if None not in pair:
                ratio = pair[0] / pair[1]
                out.write(cells(text, process.target, f"{ratio:.2f}", limit, verdict(-ratio, -limit)))
    out.write("\n## Other ratios\n\n" + cells(*heads) + "|---" * 8 + "|\n")
    out.writelines(ratio_rows(processes, False))


def write_times(out, processes):
    """Rows without a peer in their process."""
    out.write("\n## Times without a peer\n\n" + cells("work", "K", "M", "instruction set", "ns") + "|---" * 5 + "|\n")
    for process in processes:
        for row, medians in process.medians.items():
            if list(medians) == ["ours"]:
                out.write(cells(work_text(row), power(row.keys), power(row.samples), process.target,
                                f"{medians['ours']:.2f}"))


def cpu_model():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        for line in file:
            if line.startswith(("model name", "CPU implementer")):
                return line.split(":", 1)[1].strip()
    return "unknown CPU"


def main(out_path, *paths):
    processes = [Process(path) for path in paths]
    first = next(p for p in processes if "num_cpus" in p.context)
    caches = ", ".join(f"L{c['level']} {c['type'].lower()} {c['size'] // 1024} KiB"
                       for c in first.context["caches"])
    with open(out_path, "w", encoding="utf-8") as out:
        out.write("# Results\n\n")
        out.write("Written by `bench/run.sh`. Ratio: time of the peer over ours, medians of interleaved repetitions on "
                  "one thread, in its CPU time, in one process on the same data; above 1 we are faster. Times are ns a "
                  "sample (`create_...`, `init_...`: a key). K knots, M samples; times sorted and output written to before, where "
                  "nothing else is said; `fresh`: output on new pages. `bytes` reads and writes as much "
                  "without computing anything. Peers are compiled with -O3 for the baseline of the architecture, the "
                  "loops beside `rows_...` for the instruction set of our kernel.\n\n")
        out.write(f"- Machine: {cpu_model()}, {first.context['num_cpus']} CPUs, {caches}\n")
        out.write(f"- Library: qtraj {first.context['qtraj_version']}; this CPU runs: "
                  f"{', '.join(dict.fromkeys(p.target for p in processes))}\n")
        for process in processes:
            if "peers" in process.context:
                out.write(f"- Peers ({process.target}): {process.context['peers']}\n")
        out.write(f"- Date: {first.context['date']}\n\n")
        write_ratios(out, processes)
        write_times(out, processes)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
