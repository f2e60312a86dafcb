#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Prints the figures of steps.sh as the tables of docs/performance.md.

  benchmarks/steps_table.py OUT

OUT is the folder of steps.sh. Of each step latest.json is taken if it is there,
else baseline.json. The first table has the processor time of each stage (ms, one
thread) and the wall time of one and two threads, the second the work of each
stage and its time per unit (ns).
"""

import json
import pathlib
import sys

SCENES = ["embedded", "lhdl", "hip", "thigh", "shank", "shoulder", "random"]
COLUMNS = {
    "solve without contact": "free solve",
    "planes between muscles": "planes, muscles",
    "planes of bones": "planes, bones",
    "planes within muscles": "planes, sheets",
    "sorting planes": "sorting",
    "relaxation": "relaxation",
    "solve with contact": "solve",
    "volume": "volume",
    "defects": "defects",
}
UNITS = [
    ("planes between muscles", "pairs tested"),
    ("planes of bones", "pairs tested"),
    ("planes within muscles", "pairs tested"),
    ("sorting planes", "half-spaces"),
    ("relaxation", "vertex sweeps"),
    ("solve with contact", "entries of W"),
    ("solve with contact", "rows"),
    ("defects", "pairs visited"),
]


def figures(out, scene):
    for name in ("latest.json", "baseline.json"):
        path = out / scene / name
        if path.exists():
            return json.loads(path.read_text())
    return None


def row(cells):
    print("| " + " | ".join(cells) + " |")


def table(header):
    row(header)
    print("|" + "---|" * len(header))


def stages_of(step):
    return {stage["name"]: stage for stage in step["times"][0]["stages"]}


def print_times(steps):
    table(["step", *COLUMNS.values(), "other", "all", "wall, 1 and 2 threads"])
    for step in steps:
        stages = stages_of(step)
        total = step["times"][0]["processor_ms"]
        times = [stages.get(name, {}).get("processor_ms", 0) for name in COLUMNS]
        walls = [time["ms"] for time in step["times"]]
        row([
            step["step"],
            *(f"{time:.0f}" for time in times),
            f"{total - sum(times):.0f}",
            f"{total:.0f}",
            ", ".join(f"{wall:.0f}" for wall in walls),
        ])


def print_units(steps):
    table(["step", *(f"{unit} of {COLUMNS[stage]}" for stage, unit in UNITS)])
    for step in steps:
        stages = stages_of(step)
        cells = []
        for name, unit in UNITS:
            stage = stages.get(name, {})
            count = stage.get("work", {}).get(unit, 0)
            cells.append(
                f"{count} ({1e6 * stage['processor_ms'] / count:.0f} ns)"
                if count
                else ""
            )
        row([step["step"], *cells])


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    runs = [figures(pathlib.Path(sys.argv[1]), scene) for scene in SCENES]
    runs = [run for run in runs if run]
    if not runs:
        sys.exit(f"{sys.argv[1]}: has no figures; run benchmarks/steps.sh first")
    print(f"{runs[0]['processor']}, code {runs[0]['code']}; ms.\n")
    steps = [step for run in runs for step in run["steps"]]
    print_times(steps)
    print()
    print_units(steps)
    changed = [step["step"] for step in steps if not step["same"]]
    print(f"\nNot the same as recorded: {', '.join(changed) or 'none'}.")


if __name__ == "__main__":
    main()
