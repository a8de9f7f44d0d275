#!/usr/bin/env python3
"""gate.py qtraj_bench: runs the rows that have a target against a peer in the same process, with every kernel of this
CPU that has targets, and fails where a ratio is below 60 % of its target, or of what results.md has where that is less:
a regression is seen, noise is not. Limits of growth hold as they are. What fails is measured again, twice.
Exits with 77, and says so, where no such kernel runs here.
"""
import pathlib
import subprocess
import sys
import tempfile

from report import AT_LEAST, GROWTH, Process, power, work_text

SHARE = 0.6
ATTEMPTS = 3
IN_PROCESS = ("eigen", "glm", "bytes", "atan2")
NOT_RUN = 77


def reached_ratios():
    """By the first five cells of a row of results.md: work, K, M, instruction set, peer."""
    reached = {}
    for line in pathlib.Path(__file__).with_name("results.md").read_text(encoding="utf-8").splitlines():
        found = [cell.strip().strip("*") for cell in line.strip("|").split("|")]
        if len(found) >= 8 and found[7].replace(".", "").isdigit():
            reached[tuple(found[:5])] = float(found[7])
    return reached


REACHED = reached_ratios()


def names(row, who):
    name = f"{row.work}/{row.order}/{row.memory}/K:{row.keys}/M:{row.samples}"
    return {f"{name}/ours", f"{name}/{who}"}


def measured(program, target, filters):
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        subprocess.run([program, f"--target={target}", f"--benchmark_filter=^({'|'.join(sorted(filters))})(/manual_time)?$",
                        "--benchmark_repetitions=7", "--benchmark_min_time=0.01",
                        "--benchmark_enable_random_interleaving=true", f"--benchmark_out={file.name}",
                        "--benchmark_out_format=json"], check=True, stdout=subprocess.DEVNULL)
        return Process(file.name)


def least_ratio(process, row, who):
    reached = REACHED[work_text(row), power(row.keys), power(row.samples), process.target, who]
    return SHARE * min(process.target_ratio(row, who), reached)


def ratio_failures(program, target, aimed):
    process = measured(program, target, set().union(*(names(row, who) for row, who in aimed)))
    for row, who in aimed:
        medians = process.medians[row]
        ratio, least = medians[who] / medians["ours"], least_ratio(process, row, who)
        print(f"{target}: {row.work} {row.order} K {row.keys} M {row.samples}: {ratio:.2f} times {who}, gate {least:.2f}")
        if ratio < least:
            yield row, who


def growth_failures(program, target, growths):
    filters = set()
    for _, grown, base, _ in growths:
        filters |= names(grown, "ours") | names(base, "ours")
    process = measured(program, target, filters)
    for growth in growths:
        text, grown, base, limit = growth
        ratio = process.medians[grown]["ours"] / process.medians[base]["ours"]
        print(f"{target}: {text}: {ratio:.2f}, at most {limit}")
        if ratio > limit:
            yield growth


def still_failing(program, target, check, items):
    for _ in range(ATTEMPTS):
        items = items and list(check(program, target, items))
    return [f"{target}: {item}" for item in items]


def main(program):
    targets = subprocess.run([program, "--list-targets"], check=True, capture_output=True, text=True).stdout.splitlines()
    aimed = [target for target in targets if target in ("avx512 fused", "avx2 fused")]
    if not aimed:
        print("NOT RUN: this CPU, or this build, has none of the kernels that have targets")
        sys.exit(NOT_RUN)
    rows = [(row, who) for row, who, *_ in AT_LEAST if who in IN_PROCESS]
    growths = [growth for growth in GROWTH if growth[1].samples]
    failed = []
    for target in aimed:
        failed += still_failing(program, target, ratio_failures, rows)
        failed += still_failing(program, target, growth_failures, growths)
    if failed:
        sys.exit("Too slow:\n" + "\n".join(failed))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
