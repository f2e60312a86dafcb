# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Moment arms at neutral against those of another specimen."""

import dataclasses

import numpy as np

from bands import fibre_band, path_arms
from straight import STRAIGHT, Joint, straight_arms
from table import Row, Section, commands, paragraphs, plain, prose, span, table

MARGIN = 5  # mm


@dataclasses.dataclass
class Part:
    """A straight muscle of Dostal and Andrews (1981), table 1: cm from the
    centre of the right hip forwards, upwards and to the right; and what of the
    scene corresponds: muscles, and paths of lines, of which the mean counts."""

    name: str
    origin: tuple
    insertion: tuple
    muscles: tuple
    paths: tuple


PARTS = [
    Part(
        "iliopsoas",
        (2.8, 2.4, 0.5),
        (-0.2, -6.1, 1.5),
        ("iliacus_r", "psoas_major_r"),
        (("iliacus_r",), ("psoas_upper", "psoas_r")),
    ),
    Part(
        "gluteus maximus",
        (-8.7, 6.8, -4.4),
        (-0.9, -10.3, 4.7),
        ("gluteus_maximus_r",),
        (("glut_max1_r",), ("glut_max2_r",), ("glut_max3_r",)),
    ),
    Part(
        "gluteus medius, anterior",
        (2.7, 10.2, 6.2),
        (-1.8, -2.6, 7.3),
        ("gluteus_medius_r",),
        (("glut_med3_r",),),
    ),
    Part(
        "gluteus medius, middle",
        (-0.2, 13.2, 1.8),
        (-1.8, -2.6, 7.3),
        ("gluteus_medius_r",),
        (("glut_med2_r",),),
    ),
    Part(
        "gluteus medius, posterior",
        (-4.8, 9.7, -1.5),
        (-1.8, -2.6, 7.3),
        ("gluteus_medius_r",),
        (("glut_med1_r",),),
    ),
]

# The axes of flexion, adduction and rotation inwards of a right hip, in the
# axes of PARTS; the runs have the same signs.
AXES = {
    "hip_flexion": (0, 0, 1),
    "hip_adduction": (1, 0, 0),
    "hip_rotation": (0, 1, 0),
}

ABOUT = f"""
Dostal and Andrews (1981, A three-dimensional biomechanical model of hip
musculature, Journal of Biomechanics 14, 803-812) give origins and insertions of
hip muscles of one specimen about the centre of the joint (table 1; also in
data/Dostal1981.m of RWTHmediTEC/HipJointForceModel). The moment arms of their
straight lines follow from the points, here not scaled to the size of LHDL. They
are listed for the muscles of the scene beside what our runs have where all
coordinates of the hip are 0: the lines of the model as their muscles carry them
(the mean, if several correspond), the range of the fibres, and that of all
straight pairs of published points. Flexion, adduction and rotation inwards are
positive. Their iliopsoas begins where it leaves the brim of the pelvis. No
target is set, as it is another person's hip; the summary counts how many
of their arms are within {MARGIN} mm of the range of our fibres.
"""


def arms_of(run, joint, part):
    """For the coordinate that a run moves, at neutral: the arms of a part, of
    the lines, and the ranges of fibres and of straight pairs, mm."""
    frame = np.abs(run.angles).argmin()
    origin, insertion = (
        10 * np.array([point]) for point in (part.origin, part.insertion)
    )
    axis = np.array(AXES[run.name])
    theirs = straight_arms(origin, insertion, axis, np.zeros(3))[0]
    lines = np.mean([path_arms(run, path)[frame] for path in part.paths])
    bands = [fibre_band(run, muscle, run.moving) for muscle in part.muscles]
    fibres = [low[frame] for low, _ in bands] + [high[frame] for _, high in bands]
    pairs = [joint.arms(m, frame) for m in part.muscles if m in STRAIGHT]
    return theirs, lines, fibres, np.concatenate(pairs) if pairs else None


def dostal_section(runs, data):
    """The section, of runs that each move one coordinate and pass neutral."""
    joints = [Joint(run, data) for run in runs]
    cells, inside = [], []
    for part in PARTS:
        for run, joint in zip(runs, joints):
            theirs, lines, fibres, pairs = arms_of(run, joint, part)
            off = max(min(fibres) - theirs, theirs - max(fibres), 0)
            inside.append(off <= MARGIN)
            cells.append(
                [part.name, plain(run.moving), f"{theirs:.1f}", f"{lines:.1f}"]
                + [span(fibres), span(pairs) if pairs is not None else ""]
                + [f"{off:.1f}"]
            )
    head = ["muscle", "coordinate", "Dostal and Andrews, mm", "our lines, mm"]
    head += ["our fibres, mm", "straight pairs, mm", "beyond our fibres, mm"]
    row = Row(
        f"arms of Dostal and Andrews within {MARGIN} mm of our fibres at neutral",
        "none set",
        f"{sum(inside)} of {len(inside)}",
        None,
    )
    body = paragraphs(
        prose(ABOUT), commands([run.command for run in runs]), table(head, cells)
    )
    return Section("Straight lines of another specimen", body, [row])
