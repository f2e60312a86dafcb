# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""How the parts of fibres stretch at the ends of a motion."""

import numpy as np

from table import Row, Section, commands, mark, paragraphs, plain, prose, table

PARTS = 5
LEAST, MOST = 0.75, 1.35  # of the mean of a part at the end of hip flexion

ABOUT = f"""
A muscle may keep its volume and its line although all of its shortening happens
beside the joint. Each fibre is cut at rest into
{PARTS} parts of equal length, from its beginning (1) to its end ({PARTS}), and
the length of a part at either end of a motion is divided by that at rest. The
table has the means over the fibres of a muscle, and the least and the largest
part of a single fibre. The target, {LEAST:g} to {MOST:g} for each mean, is for
the end of `hip_flexion`; the other ends have none. Rest is the pose of the meshes.
"""


def part_stretches(rest, moved):
    """The stretch of each part of a fibre, of which corresponding points at
    rest and in a frame are given."""
    before, after = (
        np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(p, axis=0), axis=1))])
        for p in (rest, moved)
    )
    bounds = np.linspace(0, before[-1], PARTS + 1)
    return np.diff(np.interp(bounds, before, after)) / np.diff(bounds)


def fibre_stretches(run, muscle, frame):
    """The stretches of the fibres of a muscle in a frame: fibres x parts."""
    folder = run.frame_folders()[frame]
    pairs = zip(run.fibres("rest")[muscle], run.fibres(folder)[muscle])
    return np.array([part_stretches(rest, moved) for rest, moved in pairs])


def asked_of(run, frame):
    """Whether a frame of a run has a target: the end of hip flexion."""
    return run.name == "hip_flexion" and run.angles[frame] == run.angles.max()


def stretch_row(run, place, means):
    """The row of the summary for the end of a motion; `means` has the means of
    the parts of each muscle."""
    low = min((values.min(), plain(muscle)) for muscle, values in means.items())
    high = max((values.max(), plain(muscle)) for muscle, values in means.items())
    return Row(
        f"{run.name}, {place}: mean stretch of fifths of the fibres",
        f"{LEAST:g} to {MOST:g}",
        f"{low[0]:.2f} ({low[1]}) to {high[0]:.2f} ({high[1]})",
        bool(LEAST <= low[0] and high[0] <= MOST),
    )


def stretch_section(runs):
    cells, rows = [], []
    for run in runs:
        for frame in (int(run.angles.argmin()), int(run.angles.argmax())):
            found = {m: fibre_stretches(run, m, frame) for m in run.muscles}
            means = {muscle: parts.mean(axis=0) for muscle, parts in found.items()}
            asked, place = asked_of(run, frame), run.place(frame)
            if asked:
                rows.append(stretch_row(run, place, means))
            for muscle, parts in found.items():
                mean = means[muscle]
                met = (mean >= LEAST).all() and (mean <= MOST).all()
                cells.append(
                    [run.name, place, plain(muscle)]
                    + [f"{value:.2f}" for value in mean]
                    + [mark(bool(met) if asked else None)]
                    + [f"{parts.min():.2f}", f"{parts.max():.2f}"]
                )
    head = ["run", "at", "muscle", *map(str, range(1, PARTS + 1)), "met?"]
    head += ["least", "largest"]
    body = paragraphs(
        prose(ABOUT), commands([run.command for run in runs]), table(head, cells)
    )
    return Section("Stretch along the fibres", body, rows)
