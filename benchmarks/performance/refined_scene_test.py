# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Finer meshes of a scene are the same surfaces."""

import collections
import json
import pathlib
import tempfile
import unittest

import numpy as np
from refined_scene import refined, write_ply, write_refined_scene
from runs import read_ply

ROUNDING = 1e-12
POINTS = np.array([[0.0, 0, 0], [3, 0, 0], [0, 4, 0], [0, 0, 5]])
TRIANGLES = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])


def volume(points, triangles):
    return np.linalg.det(points[triangles]).sum() / 6


class RefinedSceneTest(unittest.TestCase):

    def test_closed_mesh_stays_closed_with_its_volume(self):
        for n in (1, 2, 3, 4):
            points, triangles = refined(POINTS, TRIANGLES, n)
            self.assertEqual(n * n * len(TRIANGLES), len(triangles))
            # As Euler has it for a sphere: V = 2 + F / 2.
            self.assertEqual(2 + len(triangles) // 2, len(points))
            np.testing.assert_array_equal(POINTS, points[: len(POINTS)])
            sides = collections.Counter(
                (int(t[i]), int(t[i - 1])) for t in triangles for i in range(3)
            )
            self.assertEqual({1}, set(sides.values()))
            self.assertTrue(all((b, a) in sides for a, b in sides))
            self.assertAlmostEqual(
                volume(POINTS, TRIANGLES), volume(points, triangles), delta=ROUNDING
            )

    def test_one_cut_leaves_the_mesh_as_it_is(self):
        points, triangles = refined(POINTS, TRIANGLES, 1)
        np.testing.assert_array_equal(POINTS, points)
        np.testing.assert_array_equal(TRIANGLES, triangles)

    def test_scene_has_finer_meshes_under_the_same_names(self):
        with tempfile.TemporaryDirectory() as name:
            source, out = pathlib.Path(name), pathlib.Path(name) / "fine"
            scene = {"muscles": [{"mesh": "a.ply"}], "bones": [{"mesh": "b.ply"}]}
            (source / "scene.json").write_text(json.dumps(scene))
            for mesh in ("a.ply", "b.ply"):
                write_ply(source / mesh, POINTS, TRIANGLES)
            write_refined_scene(source, 2, out)
            self.assertEqual(scene, json.loads((out / "scene.json").read_text()))
            self.assertEqual(16, len(read_ply(out / "a.ply")[1]))
            self.assertEqual(16, len(read_ply(out / "b.ply")[1]))


if __name__ == "__main__":
    unittest.main()
