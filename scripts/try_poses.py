#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs all poses of all scenes of public data with default options: those of
data/scenes, and scene_uniform.json of data sets that bring their own.

  scripts/try_poses.py DATA [--programs=DIR] [--out=DIR] [--only=NAME,...]

A row for each scene says how many frames there are and are usable, the smallest
proved gap and the largest stretch of all frames, and the time of the program; it
is followed by what is amiss in frames that are not usable. The runs are kept only
with --out. Exit code: 0 if every frame of every scene is usable, else 1.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent


def scenes(data):
    """Returns the scene files by name."""
    found = {file.stem: file for file in (ROOT / "data/scenes").glob("*.json")}
    for file in data.glob("*/scene_uniform.json"):
        found[file.parent.name] = file
    return dict(sorted(found.items()))


def run(program, scene, data, out):
    """Deforms a scene; returns its row, and what is amiss, a line each."""
    began = time.monotonic()
    done = subprocess.run(
        [program, f"--scene={scene}", f"--data_root={data}", f"--out={out}"],
        capture_output=True,
        text=True,
    )
    seconds = f"{time.monotonic() - began:.0f}"
    if done.returncode not in (0, 1):
        why = done.stderr.strip() or "no message"
        return ["-", "-", "-", "-", seconds], [f"exit code {done.returncode}: {why}"]
    report = json.loads((out / "report.json").read_text())
    frames = report["frames"]
    gaps = [f["smallest_gap_mm"] for f in frames if f["smallest_gap_mm"] is not None]
    stretches = [m["shape"]["max_stretch"] for f in frames for m in f["muscles"]]
    amiss = [
        f"{frame['name']}: {'; '.join(frame['shortcomings'])}"
        for frame in frames
        if not frame["usable"]
    ]
    if done.returncode == 1 and not amiss:
        amiss = [f"exit code 1: {report['summary']}"]
    row = [
        f"{len(frames)}",
        f"{sum(frame['usable'] for frame in frames)}",
        f"{min(gaps):.3f}" if gaps else "-",
        f"{max(stretches):.2f}" if stretches else "-",
        seconds,
    ]
    return row, amiss


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("data", type=pathlib.Path, metavar="DATA")
    parser.add_argument(
        "--programs", type=pathlib.Path, default=ROOT / "build/release/tools"
    )
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--only", default="", help="names of scenes, with commas")
    options = parser.parse_args()
    chosen = scenes(options.data)
    only = [name for name in options.only.split(",") if name]
    unknown = set(only) - set(chosen)
    if unknown:
        parser.error(f"--only: no scene {', '.join(sorted(unknown))}")
    print(
        "| scene | frames | usable | smallest gap mm | largest stretch | s |\n"
        "|---|---|---|---|---|---|",
        flush=True,
    )
    all_well = True
    for name, scene in chosen.items():
        if only and name not in only:
            continue
        with tempfile.TemporaryDirectory() as scratch:
            out = (options.out or pathlib.Path(scratch)) / name
            row, amiss = run(
                options.programs / "musclewarp-deform", scene, options.data, out
            )
        print(f"| {' | '.join([name, *row])} |", *amiss, sep="\n  ", flush=True)
        all_well = all_well and not amiss
    return 0 if all_well else 1


if __name__ == "__main__":
    sys.exit(main())
