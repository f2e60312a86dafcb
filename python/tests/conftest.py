# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""A small scene: two spindles and a bone that moves into one of them."""
import math
import os
import pathlib

import numpy as np
import pytest

import musclewarp as mw

SOURCE = pathlib.Path(os.environ["MUSCLEWARP_SOURCE"])
PROGRAMS = pathlib.Path(os.environ["MUSCLEWARP_PROGRAMS"])
BUILD = pathlib.Path(os.environ["MUSCLEWARP_BUILD"])
DEMO = SOURCE / "data/phantom/motion.json"


def spindle(x):
    """Points and triangles of a spindle along z, 100 mm long, at x (mm)."""
    points, triangles = np.zeros((134, 3)), []
    for v in range(132):
        ring, angle = v // 12 + 1, math.pi / 6 * (v % 12)
        radius = 10 * math.sin(math.pi / 12 * ring)
        points[v] = (x + radius * math.cos(angle), radius * math.sin(angle),
                     100 * ring / 12)
        after = v + 1 if v % 12 < 11 else v - 11
        triangles.append((v, after, v + 12 if v < 120 else 133))
        triangles.append((after, v, after - 12 if v >= 12 else 132))
    points[132], points[133] = (x, 0, 0), (x, 0, 100)
    return points, np.array(triangles)


def muscle(name, x):
    points, triangles = spindle(x)
    line = mw.Line(name, [(x, 0, 2), (x, 0, 98)])
    return mw.Muscle(name, points, triangles, lines=[line])


def small_scene():
    return mw.Scene(muscles=[muscle("psoas", 0), muscle("iliacus", 19)],
                    bones=[mw.Bone("femur", *spindle(45))])


def pushed(distance):
    """The pose in which the femur has moved by -distance along x, mm."""
    motion = np.eye(4)
    motion[0, 3] = -distance
    return mw.Pose(f"pushed by {distance}", bodies={"femur": motion})


def quick(scene=None, **choices):
    """A deformer with hulls of few vertices: enough for laws."""
    return mw.Deformer(scene or small_scene(), coarse_vertices=60, **choices)


@pytest.fixture(scope="module")
def deformer():
    return quick()
