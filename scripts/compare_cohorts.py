#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Says whether two folders of musclewarp-cohort hold the same.

usage: scripts/compare_cohorts.py A B      every file, byte for byte
       scripts/compare_cohorts.py --frames OUT
           prints name and time of every frame that is there
       scripts/compare_cohorts.py --overhead OUT WALL_S CORES
           prints the work of the jobs, and the rest of the wall clock

Compared are the bytes of meshes, tables, scenes and attachments. Of report.json the
times (keys with _ms) and the command line with its flags and paths are left out, of
group.tsv the columns of times and memory. Logs, records of jobs and pages, which
show times, have to be there in both, no more. Exit code: 0 the same, 1 not.
"""
import json
import pathlib
import sys

OF_THE_RUN = {"command", "options", "machine", "wall_ms"}
OF_THE_TIME = {"prepare_s", "frames_s", "memory_mb"}
ONLY_THERE = {"job.json", "job.log", "report.html", "group.html", "snakemake.log"}


def without_times(report):
    if isinstance(report, dict):
        return {key: without_times(value) for key, value in report.items()
                if "_ms" not in key and key not in OF_THE_RUN}
    if isinstance(report, list):
        return [without_times(entry) for entry in report]
    return report


def without_time_columns(text):
    rows = [line.split("\t") for line in text.splitlines()]
    kept = [place for place, name in enumerate(rows[0])
            if name not in OF_THE_TIME]
    return [[row[place] for place in kept] for row in rows]


def content(path):
    """What is compared of a file."""
    if path.name in ONLY_THERE:
        return None
    if path.name == "report.json":
        return without_times(json.loads(path.read_text()))
    if path.name == "group.tsv":
        return without_time_columns(path.read_text())
    return path.read_bytes()


def files(out):
    """The files by their paths, without those that begin with a dot."""
    paths = {path.relative_to(out): path for path in out.rglob("*")
             if path.is_file()}
    return {name: path for name, path in paths.items()
            if not any(part.startswith(".") for part in name.parts)}


def compare(a, b):
    one, other = files(pathlib.Path(a)), files(pathlib.Path(b))
    apart = [f"only in {a}: {name}" for name in sorted(one.keys() - other.keys())]
    apart += [f"only in {b}: {name}" for name in sorted(other.keys() - one.keys())]
    both = sorted(one.keys() & other.keys())
    apart += [f"differs: {name}" for name in both
              if content(one[name]) != content(other[name])]
    print("\n".join(apart[:20] + [f"{len(both)} files in both, {len(apart)} "
                                  "differ or are in one only"]))
    return 1 if apart or not both else 0


def frames(out):
    """A frame appears at once; whoever writes it again gives it a new time."""
    for folder in sorted(pathlib.Path(out).glob("*/*/frame_*")):
        print(folder.relative_to(out), (folder / "lines.json").stat().st_mtime_ns)
    return 0


def overhead(out, wall, cores):
    work = sum(json.loads(path.read_text())["wall_s"]
               for path in pathlib.Path(out).glob("*/*/job.json"))
    rest = float(wall) * int(cores) - work
    print(f"work of the jobs {work:.1f} s, wall clock {float(wall):.1f} s on "
          f"{cores} core(s): the engine takes {rest:.1f} s, {rest / work:.1%} of "
          "the work")
    return 0


def main(*words):
    actions = {"--frames": frames, "--overhead": overhead}
    if words and words[0] in actions:
        return actions[words[0]](*words[1:])
    if len(words) != 2:
        sys.exit(__doc__)
    return compare(*words)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
