# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Pictures of the ends of motions, before and after, from three sides."""

import subprocess

import numpy as np

from table import Section, commands, paragraphs, prose, table

ENDS = [
    ("hip_flexion", 60),
    ("hip_adduction", 40),
    ("hip_adduction", -40),
    ("hip_rotation", 30),
    ("hip_rotation", -30),
]
BEFORE = "_before"  # ends the name of a run as things were before
VIEWS = ["anterior", "lateral", "posterior"]
SIZE = 360
FLAGS = [
    f"--size={SIZE}x{SIZE}",
    "--fit=gluteus_maximus_r,gluteus_medius_r,iliacus_r",
    "--captions=",
    "--nolegend",
]

ABOUT = """
Each pair shows the end of a motion before and after a change of method, both made
with this version. Before, the areas of attachment are those found on the meshes,
each place of a muscle stays in its segment of a line (`--lines=fixed`), and nothing
keeps the curvature of fibres (`--bending_weight=0`); after, the areas are the
published ones, and these two options have their defaults. The camera of a pair is the
same but for what the picture is made to hold, the two glutei and the iliacus.
"""


def frame_at(run, angle):
    """The frame in which the moving coordinate has this angle, degrees."""
    frame = int(np.abs(run.angles - angle).argmin())
    if abs(run.angles[frame] - angle) > 0.1:
        raise ValueError(f"{run.folder}: no frame is at {angle} degrees")
    return frame


def draw(render, run, frame, view, file):
    words = [f"--in={run.folder}", f"--frames={frame}", f"--view={view}", *FLAGS]
    subprocess.run(
        [str(render), *words, f"--out={file}"], check=True, stdout=subprocess.PIPE
    )


def pictures_of(render, runs, end, plots):
    """The pictures of the end of a motion: a heading and a table."""
    name, angle = end
    cells = []
    for view in VIEWS:
        row = [view]
        for when, run in (("before", runs[name + BEFORE]), ("after", runs[name])):
            sign = "minus_" if angle < 0 else ""
            file = f"{name}_{sign}{abs(angle)}_{view}_{when}.png"
            draw(render, run, frame_at(run, angle), view, plots / file)
            row.append(f"![{when}, {view}]({plots.name}/{file})")
        cells.append(row)
    heading = f"**{name}**, {angle} degrees:"
    return paragraphs(heading, table(["from", "before", "after"], cells)).rstrip()


def pictures_section(render, runs, plots):
    """The section; `runs` are by name, with those of before."""
    names = dict.fromkeys(name for name, _ in ENDS)
    made = [runs[name + when].command for name in names for when in (BEFORE, "")]
    drawn = " ".join(["--in=OUT/RUN --frames=N --view=SIDE", *FLAGS, "--out=FILE"])
    made.append(f"musclewarp-render {drawn}")
    tables = [pictures_of(render, runs, end, plots) for end in ENDS]
    return Section("Pictures", paragraphs(prose(ABOUT), commands(made), *tables), [])
