"""The commands convert, check and sample.

Data go to standard output or a file, all else to standard error. Exit status 0; 1 where the data cannot be used; 2 where
the command is wrong. Nothing is written over without --force.
"""

from __future__ import annotations

import argparse
import os
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

import qtraj

from . import FORMATS, Recording, RecordingError, read, write


def parser() -> argparse.ArgumentParser:
    whole = argparse.ArgumentParser(prog="python -m qtraj", description="Recordings of orientations: convert, check, sample.")
    whole.add_argument("--version", action="version", version=f"qtraj {qtraj.__version__}")
    commands = whole.add_subparsers(dest="command", required=True, metavar="COMMAND")

    source = argparse.ArgumentParser(add_help=False)
    source.add_argument("input", metavar="IN", help="a file, or - for standard input")
    source.add_argument("--from", dest="from_format", choices=FORMATS, help="format of IN; found out unless given")
    source.add_argument("--order", choices=("wxyz", "xyzw"), help="order of components where nothing in the file says it")
    source.add_argument("--times", metavar="FILE", help="times beside KITTI poses")
    source.add_argument("--kernel", metavar="FILE", action="append", default=[], help="SCLK and LSK beside a C-kernel")
    source.add_argument("--track", metavar="NAME", help="topic, node or object of a file that holds several")
    source.add_argument("--conjugate", action="store_true", help="the file takes world to body")

    target = argparse.ArgumentParser(add_help=False)
    target.add_argument("output", metavar="OUT", help="a file, or - for standard output")
    target.add_argument("--to", dest="to_format", choices=("tum", "euroc", "kitti", "csv", "aem", "parquet"), help="format of OUT; by its suffix unless given")
    target.add_argument("--force", action="store_true", help="write over a file that is there")

    commands.add_parser("convert", parents=[source, target], help="from one format to another")
    commands.add_parser("check", parents=[source], help="what is wrong with a file, and what is suspicious in it")
    sample = commands.add_parser("sample", parents=[source, target], help="resample at a fixed rate")
    sample.add_argument("--method", default=None, help="as of qtraj.Trajectory; what the file prescribes, or rotation_spline")
    how = sample.add_mutually_exclusive_group(required=True)
    how.add_argument("--rate", type=float, help="samples a second")
    how.add_argument("--step", type=float, help="seconds from one sample to the next")
    how.add_argument("--count", type=int, help="how many, evenly from the first key to the last")
    sample.add_argument("--longest-gap", type=float, metavar="S", help="samples inside longer intervals are left out")
    sample.add_argument("--rates", choices=("body", "world"), help="adds angular velocities in this frame (csv, parquet)")
    return whole


def load(options: argparse.Namespace) -> Recording:
    settings = {} if options.from_format in ("bag", "gltf") else {"order": options.order}
    return read(options.input, options.from_format, track=options.track, times=options.times, kernels=options.kernel,
                conjugate=options.conjugate, **settings)  # fmt: skip


def save(options: argparse.Namespace, recording: Recording) -> None:
    if options.output != "-" and Path(options.output).exists() and not options.force:
        raise FileExistsError(f"{options.output} is there: --force writes over it")
    write(options.output, recording, options.to_format)


def curve_of(recording: Recording, options: argparse.Namespace) -> qtraj.Trajectory:
    method = options.method or recording.method or "rotation_spline"
    settings: dict[str, object] = {"tangents": recording.tangents} if method == "quaternion_hermite" else {}
    if method == "hermite":
        settings = {"omega": recording.omega, "frame": recording.frame}
    return qtraj.Trajectory(recording.times, recording.q, method, longest_gap=options.longest_gap, extrapolate="nan", **settings)  # type: ignore[arg-type]


def sampled(recording: Recording, options: argparse.Namespace) -> Recording:
    """A recording of samples; those in gaps are left out."""
    curve = curve_of(recording, options)
    with np.errstate(invalid="ignore"):
        times, q = curve.uniform(rate=options.rate, step=options.step, count=options.count)
    good = ~np.isnan(q).any(axis=1)
    times, q = times[good], q[good]
    stamps = None
    if recording.nanoseconds is not None and len(recording):
        stamps = recording.nanoseconds[0] + np.rint(times * 1e9).astype(np.int64)
    positions = None
    if recording.positions is not None:
        positions = qtraj.VectorCurve(recording.times, recording.positions, "cubic" if curve.method != "step" else "step")(times)
    omega = curve(times, 1, frame=options.rates) if options.rates else None
    return replace(recording, times=times, q=q, nanoseconds=stamps, positions=positions, omega=omega, frame=options.rates)


def report(recording: Recording) -> tuple[list[str], bool]:
    """Lines about a recording, and whether curves can be drawn through it as it is."""
    lines = [f"keys            {len(recording)}"]
    if len(recording) < 2:
        return [*lines, "FAULT           fewer than two keys"], False
    found = qtraj.check_keys(recording.times, recording.q)
    steps = np.diff(recording.times[found.status == 0])
    first, last = float(recording.times[0]), float(recording.times[-1])
    lines.append(f"span            {last - first:.9g} s, from {first!r} to {last!r}")
    if len(steps):
        middle = float(np.median(steps))
        gaps = int((steps > 5 * middle).sum())
        lines.append(f"intervals       {steps.min():.6g} / {middle:.6g} / {steps.max():.6g} s (shortest, median, longest)")
        lines.append(f"gaps            {gaps} intervals longer than five medians" + (f", the longest before key {found.longest_interval_index}" if gaps else ""))
    lines.append(f"norm            off 1 by up to {found.worst_norm_error:.2g} (key {found.worst_norm_index})")
    if found.worst_norm_error > 0.01:
        lines.append("                suspicious: other columns, another type, rows for columns?")
    lines.append(f"sign changes    {found.sign_changes}, harmless")
    lines.append(f"largest step    {np.degrees(found.largest_angle):.4g} degrees (key {found.largest_angle_index})")
    if found.largest_angle > np.radians(150):
        lines.append("                suspicious: near half a turn the way round is a matter of chance; another order of components?")
    for key in np.flatnonzero(found.status)[:20]:
        lines.append(f"FAULT           key {key}: {qtraj.status_text(int(found.status[key]))}")
    if found.faults > 20:
        lines.append(f"FAULT           and {found.faults - 20} more")
    return lines, found.faults == 0


def run(options: argparse.Namespace) -> int:
    recording = load(options)
    if options.command == "convert":
        save(options, recording)
    elif options.command == "sample":
        save(options, sampled(recording, options))
    else:
        lines, usable = report(recording)
        print("\n".join(lines))
        return 0 if usable else 1
    return 0


def main(arguments: list[str] | None = None) -> int:
    options = parser().parse_args(arguments)
    try:
        return run(options)
    except BrokenPipeError:
        # whoever read has enough; Python would complain about the rest at its end
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except FileExistsError as wrong:
        print(f"qtraj: {wrong}", file=sys.stderr)
        return 2
    except (RecordingError, qtraj.Error, OSError, ImportError) as wrong:
        print(f"qtraj: {wrong}", file=sys.stderr)
        return 1
    except (TypeError, ValueError) as wrong:
        print(f"qtraj: {wrong}", file=sys.stderr)
        return 2
