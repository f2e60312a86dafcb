#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/validation.md and its plots from finished runs; called by
benchmarks/validation.sh, which makes the runs.

  benchmarks/validation/page.py DATA OUT [--page=docs/validation.md]
      [--render=PROGRAM]

Needs the python3-numpy of Debian. OUT/<run>/command.txt has the command of
each run as the page shows it.
"""

import argparse
import json
import pathlib
import subprocess
import sys

import arms
import dostal
import fine_fibres
import frames
import literature
import made_lines
import pictures
import postures
import shape_facts
import straight
import stretch
from runs import Run
from table import paragraphs, prose, table_of

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
MOTIONS = ["hip_flexion", "hip_adduction", "hip_rotation"]
FOUND = "hip_flexion_found"  # as hip_flexion, with areas found on the meshes
POSTURES = "hip_postures"  # of a design
POSES = ["bodyparts3d_hip", "bodyparts3d_hamstrings", "bodyparts3d_thigh"]

NOTE = "<!-- Written by benchmarks/validation.sh; do not edit. -->"


def head(unmet, report, flags):
    machine = report["machine"]
    return [
        "# Validation",
        NOTE,
        prose(
            "What is asked of musclewarp with certified contact, and what it reaches",
            "on public data ([where they come from](../README.md#public-data-sets)).",
            unmet,
        ),
        "    benchmarks/validation.sh DATA OUT" + flags,
        prose(
            "makes the runs and writes this page and its plots. The version is",
            f"{report['version']}, the processor {machine['processor']}, used with",
            f"{machine['threads']} threads. OUT has a folder for each run, of the name",
            "that the tables give. [report.md](report.md) and the",
            "[glossary](glossary.md) explain the terms, [results.md](results.md) has",
            "further results.",
        ),
    ]


def summary(sections):
    """The summary: what is not met is red."""
    rows = [row for section in sections for row in section.rows]
    asked = [row for row in rows if row.met is not None]
    failed = sum(not row.met for row in asked)
    if failed:
        unmet = f"Of {len(asked)} targets {failed} are not met; 🔴 marks them."
    else:
        unmet = f"All {len(asked)} targets are met."
    return unmet, table_of(rows)


def finished_runs(out, names):
    """The runs of these names that are in a folder, by name."""
    runs = {}
    for name in names:
        command = out / name / "command.txt"
        if command.exists():
            runs[name] = Run(out / name, command.read_text().strip())
        elif name != "bodyparts3d_thigh":
            raise ValueError(f"{out / name}: there is no finished run")
    return runs


def sections_of(data, out, plots, render):
    """The sections, and the runs that are asked something, by name."""
    runs = finished_runs(out, [*MOTIONS, *POSES])
    by_found = finished_runs(out, [FOUND])[FOUND]
    names = made_lines.MOTIONS
    guided = [name + made_lines.GUIDED for name in names]
    made = finished_runs(out, [*names, *guided])
    motions, every = [runs[name] for name in MOTIONS], list(runs.values())
    flexion, *others = motions
    sections = [
        arms.opensim_section(flexion, data, out, REPOSITORY / "docs/results.md"),
        literature.fibres_section(motions, by_found, data, plots, psoas_number=7),
        fine_fibres.fine_section(motions, data, fibres_number=2),
        made_lines.made_lines_section(made, data, plots),
        shape_facts.shapes_section(made, data, plots),
        straight.pairs_section(flexion, data),
        dostal.dostal_section(motions, data),
        arms.psoas_section(flexion, data, plots),
        frames.attachments_section(every),
        stretch.stretch_section([flexion, by_found, *others]),
        frames.slices_section(every),
        frames.smoothness_section(motions),
        postures.postures_section(
            finished_runs(out, [POSTURES])[POSTURES],
            json.loads((out / f"{POSTURES}.fit.json").read_text()),
        ),
    ]
    if render:
        before = finished_runs(out, [name + pictures.BEFORE for name in MOTIONS])
        sections.append(pictures.pictures_section(render, runs | before, plots))
    return sections, runs


def write_page(data, out, page, render):
    plots = page.parent / page.stem
    plots.mkdir(parents=True, exist_ok=True)
    sections, runs = sections_of(data, out, plots, render)
    unmet, rows = summary(sections)
    flags = " --all" if "bodyparts3d_thigh" in runs else ""
    flags += " --pictures" if render else ""
    flags += " --opensim=TABLE" if (out / "opensim.txt").exists() else ""
    parts = [*head(unmet, runs[MOTIONS[0]].report, flags), rows]
    for k, section in enumerate(sections, 1):
        parts += [f"## {k}. {section.title}", section.text.rstrip()]
    page.write_text(paragraphs(*parts), encoding="utf-8")
    print(f"{page}: {unmet}")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument(
        "--page", type=pathlib.Path, default=REPOSITORY / "docs/validation.md"
    )
    parser.add_argument(
        "--render", type=pathlib.Path, help="musclewarp-render, to make pictures"
    )
    args = parser.parse_args()
    paths = (args.data.resolve(), args.out.resolve(), args.page.resolve())
    try:
        write_page(*paths, args.render)
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"validation: {error}")


if __name__ == "__main__":
    main()
