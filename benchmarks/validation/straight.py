# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Straight lines between published points of a hip, and their moment arms."""

import json

import numpy as np

from bands import Published
from literature import MODENESE_KOHOUT, percent, score_of, scores
from table import Row, Section, commands, paragraphs, plain, prose, span, table

ATTACHMENTS = "lhdl_hip/attachments.json"
FEMUR = "femur_r"
RADIUS = 8  # mm, as the scene has it: what a muscle holds of an area
# The muscles that no bone bends: a straight line may stand for a fibre.
STRAIGHT = ["gluteus_maximus_r", "gluteus_medius_r"]

ABOUT_PAIRS = """
What could any fibre reach that runs straight from a published origin of this
specimen to a published insertion? All pairs of landmarks of the two areas of a
muscle are taken as straight lines, the origin on the pelvis, the insertion on
the femur of each frame, and the band from the least to the largest moment arm
about the landmark HJC is scored as those of the fibres are. Areas that the mesh
does not reach (the insertion of the gluteus maximus beside the knee, by its
tract) are left out. A band beyond that asks for fibres that something bends, or
for another anatomy. This is why the covered part of the gluteus medius has its
target at 42 % and its aim at 55 %: {neutral} Fibres of the gluteus maximus bend
around bones and may reach more. Iliacus and psoas bend over the brim of the
pelvis, and straight lines say nothing of them.
"""


def rigid_motion(before, after):
    """The rotation and the translation that take points to others best."""
    first, second = before.mean(axis=0), after.mean(axis=0)
    u, _, vt = np.linalg.svd((before - first).T @ (after - second))
    u[:, -1] *= np.linalg.det(u @ vt)
    turn = (u @ vt).T
    return turn, second - turn @ first


def axis_of(turn):
    """The axis of a rotation by less than half a turn, of length 1."""
    axis = np.array(
        [turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]
    )
    return axis / np.linalg.norm(axis)


def straight_arms(origins, insertions, axis, centre):
    """The moment arms of all straight lines from origins to insertions, mm:
    how much they shorten as the insertions turn about an axis (per radian)."""
    along = insertions[None] - origins[:, None]
    along = along / np.linalg.norm(along, axis=2, keepdims=True)
    moving = np.cross(axis, insertions - centre)
    return -np.einsum("oik,ik->oi", along, moving).ravel()


def reached_points(areas, vertices):
    """The points of the published areas that some vertex of a muscle is near."""
    reached = []
    for area in areas:
        points = np.array(area["points"])
        offsets = points[:, None] - vertices[None]
        if np.linalg.norm(offsets, axis=2).min() <= RADIUS:
            reached.append(points)
    return np.concatenate(reached)


class Joint:
    """The hip of a run in which one coordinate moves: the axis of the
    coordinate, and the femur of each frame from that of the published points."""

    def __init__(self, run, data):
        read = json.loads((data / ATTACHMENTS).read_text())
        self.points = {
            muscle: [
                reached_points(sets[end], run.mesh("rest", muscle)[0])
                for end in ("origin", "insertion")
            ]
            for muscle, sets in read["muscles"].items()
            if muscle in STRAIGHT
        }
        self.centre = np.array(read["landmarks"]["HJC"])
        rest, _ = run.mesh("rest", FEMUR)
        self.motions = [
            rigid_motion(rest, run.mesh(folder, FEMUR)[0])
            for folder in run.frame_folders()
        ]
        low, high = np.argmin(run.angles), np.argmax(run.angles)
        self.axis = axis_of(self.motions[high][0] @ self.motions[low][0].T)

    def arms(self, muscle, frame):
        """The moment arms of all straight lines of a muscle in a frame, mm."""
        origins, insertions = self.points[muscle]
        turn, shift = self.motions[frame]
        moved = insertions @ turn.T + shift
        return straight_arms(origins, moved, self.axis, self.centre)

    def band(self, muscle):
        """The least and the largest moment arm in each frame, mm."""
        arms = np.array([self.arms(muscle, k) for k in range(len(self.motions))])
        return arms.min(axis=1), arms.max(axis=1)


def pairs_section(run, data):
    published = Published(data / "literature/blemker2005_hip_flexion.csv")
    joint, found = Joint(run, data), scores(run, data)
    neutral = np.abs(run.angles).argmin()
    cells, rows, largest = [], [], {}
    for muscle in STRAIGHT:
        low, high = joint.band(muscle)
        largest[muscle] = high[neutral]
        score = published.score(muscle, run.angles, low, high)
        reached = [100 * part for part in score]
        theirs = MODENESE_KOHOUT["hip_flexion"][muscle]
        cells.append(
            [plain(muscle), len(joint.arms(muscle, 0)), percent(reached)]
            + [percent(score_of(found, muscle)), percent(theirs)]
            + [span([low[neutral], high[neutral]])]
            + [span([band[neutral] for band in published.band(muscle, run.angles)])]
        )
        what = f"straight pairs over hip flexion, {plain(muscle)}: covered / IoU"
        rows.append(Row(what, "none set", f"{percent(reached)} %", None))
    head = ["muscle", "pairs", "straight pairs: covered / IoU, %", "fibres", "M&K"]
    head += ["pairs at neutral, mm", "published at neutral, mm"]
    medius = (
        f"at neutral the arms of its pairs reach {largest['gluteus_medius_r']:.1f} mm,"
        f" those of the published band"
        f" {published.band('gluteus_medius_r', 0)[1]:.1f} mm."
    )
    about = prose(ABOUT_PAIRS.format(neutral=medius))
    body = paragraphs(about, commands([run.command]), table(head, cells))
    return Section("What straight lines could reach", body, rows)
