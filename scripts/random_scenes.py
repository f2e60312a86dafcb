#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Deforms random anatomies (musclewarp-phantom --scene=random), one for each
seed, and says what certified contact makes of them.

  scripts/random_scenes.py --build=build/release --seeds=1-300 --out=DIR --vary

In every frame that the report calls usable, and at rest, CGAL looks for
crossings (tests/certificate/frame_check.cc, which has nothing of musclewarp in
it). With --vary the seed also decides on a size of 1e-3 to 1e3 times that of the
scene, an offset of up to 9e6 mm along each axis, 50 to 50 000 vertices for each
muscle and one to six poses. A seed has one of these outcomes:

  usable          every frame is usable
  not usable      musclewarp-deform says which frames are not, and why
  refused         musclewarp-deform refuses the scene (exit code 2) and says why
  falsely usable  a frame is called usable, but CGAL finds crossings
  time-out        a program was still running after --timeout_s
  crash           a program was ended by a signal or had another exit code

DIR/seeds.csv has a line for each seed. DIR/<seed> keeps the scene, the report
and what the program printed; the meshes of the frames are kept where the
outcome is not "usable", or for all seeds with --keep_meshes. The same seed
gives the same scene on every machine.

Exit code: 0, or 1 if a seed is falsely usable, crashed or ran into the time-out.
"""

import argparse
import collections
import concurrent.futures
import csv
import dataclasses
import json
import math
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys

OUTCOMES = [
    "usable",
    "not usable",
    "refused",
    "falsely usable",
    "time-out",
    "crash",
]
# Of all muscles of a varied scene.
MOST_VERTICES = 40_000

FAILURES = {"falsely usable", "time-out", "crash"}


@dataclasses.dataclass
class Row:
    """What came of a seed; the fields are the columns of seeds.csv."""

    seed: int
    muscles: int = 0
    bones: int = 0
    size: float = 1
    offset_mm: float = 0
    vertices: int = 0
    rest_crossings: int = 0
    frames: int = 0
    usable_frames: int = 0
    outcome: str = ""
    preparation_s: float = 0
    slowest_frame_s: float = 0
    detail: str = ""


def seeds_of(text):
    """Returns the seeds of a list such as 1-300 or 3,5,10-12."""
    seeds = []
    for part in text.split(","):
        found = re.fullmatch(r"(\d+)(?:-(\d+))?", part.strip())
        if not found:
            raise argparse.ArgumentTypeError(
                f'"{part}" is neither a seed nor a range such as 1-300'
            )
        first, last = int(found[1]), int(found[2] or found[1])
        if last < first:
            raise argparse.ArgumentTypeError(f'"{part}" has no seeds: turn it round')
        seeds.extend(range(first, last + 1))
    return sorted(set(seeds))


def run(command, log, options):
    """Runs a program, with its output in a file. Returns the exit code (that of
    a signal is negative), or None if it took too long."""
    environment = {**os.environ, "OMP_NUM_THREADS": str(options.threads)}
    with open(log, "w", encoding="utf-8") as file:
        try:
            return subprocess.run(
                [str(word) for word in command],
                stdout=file,
                stderr=subprocess.STDOUT,
                timeout=options.timeout_s,
                env=environment,
            ).returncode
        except subprocess.TimeoutExpired:
            return None


def last_line(log):
    lines = log.read_text(errors="replace").strip().splitlines()
    return lines[-1] if lines else "no output"


def crossings(folder, muscles, work, options):
    """Returns what CGAL finds to cross in a folder of a frame, a line each."""
    log = work / "check.log"
    code = run([options.frame_check, folder, *sorted(muscles)], log, options)
    if code not in (0, 1):
        raise RuntimeError(f"frame_check: exit code {code}: {last_line(log)}")
    return log.read_text().strip().splitlines()


def read_report(row, report):
    """Fills the row with what the report says. Returns it as JSON, or None if
    there is none yet."""
    if not report.exists():
        return None
    read = json.loads(report.read_text())
    prepare = read["prepare"]
    row.rest_crossings = read["rest"]["intersections"]["triangle_pairs"]
    row.usable_frames = sum(frame["usable"] for frame in read["frames"])
    row.preparation_s = (prepare["wall_ms"] + prepare.get("contact_ms", 0)) / 1000
    row.slowest_frame_s = (
        max((frame["wall_ms"] for frame in read["frames"]), default=0) / 1000
    )
    return read


def kind_of(shortcoming):
    """Returns the kind of a shortcoming: its sentence without names and
    numbers."""
    text = re.sub(r"\([^)]*\)|around.*", "", shortcoming).partition(": ")[2]
    if "crossing" in text or "inside" in text:
        between = shortcoming.partition(":")[0]
        muscles = len(re.findall(r"\bmuscle_", between))
        return "muscles cross" if muscles == 2 else "muscle and bone cross"
    if "self-intersecting" in text:
        return "a muscle crosses itself"
    if "folded" in text:
        return "folded triangles"
    if "volume" in text:
        return "volume off"
    if "moved by" in text:
        return "moved too far by contact"
    return text or shortcoming


def why_not_usable(report):
    """Returns the kinds of shortcomings, and for frames without one why their
    solve stopped, the most frequent first."""
    kinds = collections.Counter()
    for frame in report["frames"]:
        if frame["usable"]:
            continue
        found = {kind_of(text) for text in frame.get("shortcomings", [])}
        if not found:
            found = {f"stopped: {frame['stop_reason']}"}
        kinds.update(found)
    return "; ".join(kind for kind, _ in kinds.most_common())


def classify(row, code, report, work, options):
    """Sets the outcome of a run of musclewarp-deform, and its detail."""
    log = work / "deform.log"
    if code is None:
        row.outcome = "time-out"
        row.detail = f"musclewarp-deform: {last_line(log)}"
    elif code == 2:
        row.outcome, row.detail = "refused", last_line(log)
    elif code not in (0, 1) or report is None:
        row.outcome = "crash"
        row.detail = f"musclewarp-deform: exit code {code}: {last_line(log)}"
    else:
        row.outcome = "usable" if code == 0 else "not usable"
        row.detail = why_not_usable(report)
    if report is None:
        return
    muscles = {muscle["name"] for muscle in report["prepare"]["muscles"]}
    for frame in report["frames"]:
        if not frame["usable"]:
            continue
        name = f"frame_{frame['index']:04}"
        found = crossings(work / "out" / name, muscles, work, options)
        if found:
            row.outcome, row.detail = "falsely usable", f"{name}: {found[0]}"
            return


def varied(seed, row):
    """Draws the size, place and numbers of the scene of a seed; returns flags of
    musclewarp-phantom."""
    draw = random.Random(seed)
    row.size = 10 ** draw.uniform(-3, 3)
    row.offset_mm = draw.choice([-1, 1]) * 10 ** draw.uniform(0, math.log10(9e6))
    row.vertices = round(10 ** draw.uniform(math.log10(50), math.log10(50_000)))
    muscles = draw.randint(2, max(2, min(20, MOST_VERTICES // row.vertices)))
    return [f"--size={row.size!r}", f"--offset={row.offset_mm!r}",
            f"--num_vertices={row.vertices}", f"--num_muscles={muscles}",
            f"--num_poses={draw.randint(1, 6)}"]


def run_seed(seed, options):
    """Makes the scene of a seed and deforms it."""
    row = Row(seed)
    work = options.out / str(seed)
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    command = [options.programs / "musclewarp-phantom", "--scene=random"]
    command += [f"--seed={seed}"]
    command += (varied(seed, row) if options.vary
                else [f"--num_muscles={options.num_muscles}"])
    log = work / "phantom.log"
    code = run([*command, f"--out={work / 'scene'}"], log, options)
    if code != 0:
        row.outcome = "time-out" if code is None else "crash"
        row.detail = f"musclewarp-phantom: exit code {code}: {last_line(log)}"
        return row
    scene = json.loads((work / "scene/scene.json").read_text())
    row.muscles, row.bones = len(scene["muscles"]), len(scene["bones"])
    row.frames = len(scene["poses"])
    command = [options.programs / "musclewarp-deform", f"--out={work / 'out'}"]
    command += [f"--scene={work / 'scene/scene.json'}"]
    code = run(command, work / "deform.log", options)
    report = read_report(row, work / "out/report.json")
    try:
        classify(row, code, report, work, options)
    except RuntimeError as error:
        row.outcome, row.detail = "crash", str(error)
    if row.outcome == "usable" and not options.keep_meshes:
        for folder in [*(work / "out").glob("frame_*"), work / "out/rest"]:
            shutil.rmtree(folder)
    return row


def write_csv(rows, file):
    names = [field.name for field in dataclasses.fields(Row)]
    with open(file, "w", newline="", encoding="utf-8") as out:
        writer = csv.writer(out, lineterminator="\n")
        writer.writerow(names)
        for row in sorted(rows, key=lambda row: row.seed):
            values = [getattr(row, name) for name in names]
            writer.writerow(
                f"{value:.3f}" if isinstance(value, float) else value
                for value in values
            )


def seeds_in(rows, at_most=12):
    seeds = [str(row.seed) for row in sorted(rows, key=lambda row: row.seed)]
    more = len(seeds) - at_most
    return ", ".join(seeds[:at_most]) + (f" and {more} more" if more > 0 else "")


def summary(rows):
    """Returns tables of the outcomes and of their details, in Markdown."""
    lines = [
        "| outcome | seeds | frames | usable frames | which |",
        "|---|---|---|---|---|",
    ]
    groups = [(name, [r for r in rows if r.outcome == name]) for name in OUTCOMES]
    for name, group in [*groups, ("all", rows)]:
        frames = sum(row.frames for row in group)
        usable = sum(row.usable_frames for row in group)
        which = "" if name == "all" else seeds_in(group)
        lines.append(f"| {name} | {len(group)} | {frames} | {usable} | {which} |")
    details = collections.defaultdict(list)
    for row in rows:
        if row.outcome != "usable":
            # Names and numbers differ from seed to seed.
            text = re.sub(r"\d+(\.\d+)?", "N", row.detail.replace("|", "/"))
            details[(row.outcome, text)].append(row)
    if details:
        lines += ["", "| outcome | reason | seeds | which |", "|---|---|---|---|"]
    for (outcome, text), group in sorted(
        details.items(), key=lambda item: (OUTCOMES.index(item[0][0]), -len(item[1]))
    ):
        lines.append(f"| {outcome} | {text} | {len(group)} | {seeds_in(group)} |")
    return "\n".join(lines) + "\n"


def parse():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--build", required=True, type=pathlib.Path,
                        help="folder of the build, with its tests")
    parser.add_argument("--seeds", required=True, type=seeds_of, help="1-300 or 3,7")
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=1, help="seeds at a time")
    parser.add_argument(
        "--threads", type=int, default=0, help="of each program; 0: cores / jobs"
    )
    parser.add_argument(
        "--timeout_s", type=float, default=600, help="for each program"
    )
    parser.add_argument("--num_muscles", type=int, default=0, help="0: drawn")
    parser.add_argument("--vary", action="store_true",
                        help="draw sizes, places and numbers, too")
    parser.add_argument("--keep_meshes", action="store_true")
    parser.add_argument("--table", type=pathlib.Path, help="file for the summary")
    options = parser.parse_args()
    if options.jobs < 1:
        parser.error(f"--jobs is {options.jobs}; 1 or more is allowed")
    if options.timeout_s <= 0:
        parser.error(f"--timeout_s is {options.timeout_s}; it must be above 0")
    if options.threads < 0:
        parser.error(f"--threads is {options.threads}; 0 or more is allowed")
    options.programs = (options.build / "tools").resolve()
    options.frame_check = (options.build / "tests/certificate/frame_check").resolve()
    for program in (options.programs / "musclewarp-phantom",
                    options.programs / "musclewarp-deform", options.frame_check):
        if not program.exists():
            parser.error(f"--build: {program} is not built")
    options.threads = options.threads or max(1, (os.cpu_count() or 1) // options.jobs)
    return options


def main():
    options = parse()
    options.out.mkdir(parents=True, exist_ok=True)
    rows = []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        started = [pool.submit(run_seed, seed, options) for seed in options.seeds]
        for done in concurrent.futures.as_completed(started):
            row = done.result()
            rows.append(row)
            write_csv(rows, options.out / "seeds.csv")
            print(
                f"seed {row.seed}: {row.muscles} muscles, {row.bones} bones, "
                f"{row.usable_frames} of {row.frames} frames usable, {row.outcome}"
                + (f" ({row.detail})" if row.detail else ""),
                flush=True,
            )
    table = summary(rows)
    print("\n" + table)
    if options.table:
        options.table.write_text(table)
    return 1 if any(row.outcome in FAILURES for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
