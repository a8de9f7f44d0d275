#!/usr/bin/env python3
"""gate.py qtraj_bench: runs the rows that have a target against a peer in the same process, with every kernel of this
CPU that has targets, and fails where a ratio is below 60 % of its target, or of what results.md has where that is less:
a regression is seen, noise is not. Limits of growth hold as they are.

A time is the least processor time of interleaved repetitions, as what else the machine does only adds to it. What fails
is measured again, up to six times, and of both sides the least of all counts: no regression gets away by being repeated.
Exits with 77, and says so, where no such kernel runs here; also where something is too slow, but not as much as twice,
while others use the processors as well: what they take of caches and memory is no fault of ours.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from report import AT_LEAST, GROWTH, Process, power, work_text

SHARE = 0.6
ATTEMPTS = 6
IN_PROCESS = ("eigen", "glm", "bytes", "atan2", "calls", "cursors", "loop", "memcpy", "sampling")
NOT_RUN = 77
BUSY = 0.25  # processors that others use, on average
GROSS = 2.0  # so many times too slow is no effect of others


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


def seconds_of_others():
    """Processor seconds since the start that went to others than this process and its children."""
    try:
        with open("/proc/stat", encoding="ascii") as file:
            user, nice, system, _, _, irq, softirq, steal = map(int, file.readline().split()[1:9])
    except OSError:
        return 0.0
    ticks = user + nice + system + irq + softirq + steal
    return ticks / os.sysconf("SC_CLK_TCK") - sum(os.times()[:4])


class Measured:
    """Least times in ns per sample with one kernel, of all measurements so far."""

    def __init__(self, program, target):
        self.program, self.target = program, target
        self.least = {}

    def measure(self, filters):
        with tempfile.NamedTemporaryFile(suffix=".json") as file:
            subprocess.run([self.program, f"--target={self.target}",
                            f"--benchmark_filter=^({'|'.join(sorted(filters))})(/manual_time)?$",
                            "--benchmark_repetitions=7", "--benchmark_min_time=0.01",
                            "--benchmark_enable_random_interleaving=true", f"--benchmark_out={file.name}",
                            "--benchmark_out_format=json"], check=True, stdout=subprocess.DEVNULL)
            process = Process(file.name, min)
        for row, times in process.medians.items():
            for who, time in times.items():
                self.least[row, who] = min(time, self.least.get((row, who), time))
        return process


def least_ratio(process, row, who):
    target = process.target_ratio(row, who)
    # a row that results.md does not have yet is held to its target
    reached = REACHED.get((work_text(row), power(row.keys), power(row.samples), process.target, who), target)
    return SHARE * min(target, reached)


def ratio_failures(measured, aimed):
    process = measured.measure(set().union(*(names(row, who) for row, who in aimed)))
    for row, who in aimed:
        ratio, least = measured.least[row, who] / measured.least[row, "ours"], least_ratio(process, row, who)
        print(f"{measured.target}: {row.work} {row.order} K {row.keys} M {row.samples}: {ratio:.2f} times {who}, "
              f"gate {least:.2f}")
        if ratio < least:
            yield (row, who), least / ratio


def growth_failures(measured, growths):
    filters = set()
    for _, grown, base, _ in growths:
        filters |= names(grown, "ours") | names(base, "ours")
    measured.measure(filters)
    for growth in growths:
        text, grown, base, limit = growth
        ratio = measured.least[grown, "ours"] / measured.least[base, "ours"]
        print(f"{measured.target}: {text}: {ratio:.2f}, at most {limit}")
        if ratio > limit:
            yield growth, ratio / limit


def still_failing(program, target, check, items):
    """What is too slow, and how many times."""
    measured = Measured(program, target)
    failed = []
    for _ in range(ATTEMPTS):
        failed = list(check(measured, items))
        items = [item for item, _ in failed]
        if not items:
            break
    return [(f"{target}: {item}", times) for item, times in failed]


def main(program):
    targets = subprocess.run([program, "--list-targets"], check=True, capture_output=True, text=True).stdout.splitlines()
    aimed = [target for target in targets if target in ("avx512 fused", "avx2 fused")]
    if not aimed:
        print("NOT RUN: this CPU, or this build, has none of the kernels that have targets")
        sys.exit(NOT_RUN)
    rows = [(row, who) for row, who, *_ in AT_LEAST if who in IN_PROCESS]
    growths = [growth for growth in GROWTH if growth[1].samples]
    failed = []
    others, start = seconds_of_others(), time.monotonic()
    for target in aimed:
        failed += still_failing(program, target, ratio_failures, rows)
        failed += still_failing(program, target, growth_failures, growths)
    if failed:
        print("Too slow:", *(f"{times:.2f} times, {item}" for item, times in failed), sep="\n")
        busy = (seconds_of_others() - others) / (time.monotonic() - start)
        if busy > BUSY and max(times for _, times in failed) < GROSS:
            print(f"NOT JUDGED: others used {busy:.2f} processors meanwhile. Repeat it when they are done.")
            sys.exit(NOT_RUN)
        sys.exit(1)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
