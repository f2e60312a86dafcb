# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Two muscles given as arrays, and a bone that pushes one into the other."""
import numpy as np

import musclewarp as mw


def spindle(x, rings=11, around=12):
    """Points and triangles of a spindle along z, 100 mm long, at x (mm)."""
    z, angle = np.mgrid[1:rings + 1, 0:around]
    radius = 10 * np.sin(np.pi / (rings + 1) * z)
    angle = 2 * np.pi / around * angle
    sides = np.stack([x + radius * np.cos(angle), radius * np.sin(angle),
                      100 / (rings + 1) * z], axis=-1).reshape(-1, 3)
    points = np.vstack([sides, [(x, 0, 0), (x, 0, 100)]])
    v = np.arange(rings * around)
    after = v - v % around + (v + 1) % around
    above = np.where(v < (rings - 1) * around, v + around, len(v) + 1)
    below = np.where(v >= around, after - around, len(v))
    triangles = np.vstack([np.stack([v, after, above], axis=1),
                           np.stack([after, v, below], axis=1)])
    return points, triangles


def muscle(name, x):
    return mw.Muscle(name, *spindle(x),
                     lines=[mw.Line(name, [(x, 0, 2), (x, 0, 98)])])


scene = mw.Scene(muscles=[muscle("psoas", 0), muscle("iliacus", 19)],
                 bones=[mw.Bone("femur", *spindle(45))])
deformer = mw.Deformer(scene)

motion = np.eye(4)
motion[0, 3] = -10  # mm: 4 mm into the iliacus
frame = deformer.move_to(mw.Pose("pushed", bodies={"femur": motion}))
print(frame)
moved = frame["iliacus"].points - deformer.rest_frame["iliacus"].points
print(f"the iliacus moved by {np.linalg.norm(moved, axis=1).max():.1f} mm")
assert frame.usable and frame.crossing_pairs == 0
