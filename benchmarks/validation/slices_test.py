# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""/usr/bin/python3 -m unittest discover -s benchmarks/validation -p '*_test.py'"""

import unittest

import numpy as np

from slices import Slices, course, loops_of

ROUNDING = 1e-12  # relative
LENGTH, AROUND, RINGS = 100.0, 24, 41
ALONG = np.array([0.0, 0.0, 1.0])


def spindle():
    """A closed spindle along z."""
    z = np.linspace(0, LENGTH, RINGS + 2)[1:-1]
    angle = 2 * np.pi * np.arange(AROUND) / AROUND
    radius = 2 + 10 * np.sin(np.pi * z / LENGTH)
    rings = [
        np.stack([r * np.cos(angle), r * np.sin(angle), np.full(AROUND, h)], axis=1)
        for r, h in zip(radius, z)
    ]
    points = np.concatenate([*rings, [[0, 0, 0], [0, 0, LENGTH]]])
    first, last = len(points) - 2, len(points) - 1
    triangles = []
    for k in range(RINGS * AROUND):
        following = k + 1 if (k + 1) % AROUND else k + 1 - AROUND
        if k < AROUND:
            triangles.append([following, k, first])
        if k >= (RINGS - 1) * AROUND:
            triangles.append([k, following, last])
        else:
            triangles.append([k, following, following + AROUND])
            triangles.append([k, following + AROUND, k + AROUND])
    return points, np.array(triangles)


class SlicesTest(unittest.TestCase):
    def setUp(self):
        self.points, triangles = spindle()
        self.slices = Slices(self.points, triangles, ALONG)

    def test_slices_at_rest_are_nearly_equal(self):
        volumes = self.slices.at_rest[0]
        np.testing.assert_allclose(volumes, volumes.mean(), rtol=0.01)

    def test_affine_maps_change_all_slices_alike(self):
        matrix = np.array([[0.6, -0.8, 0.1], [0.8, 0.6, 0.3], [0.0, 0.5, 2.0]])
        ratios = self.slices.ratios(self.points @ matrix.T + [5, 6, 7])
        np.testing.assert_allclose(ratios, np.linalg.det(matrix), rtol=ROUNDING * 100)

    def test_twisting_keeps_the_slices(self):
        angle = self.points[:, 2] / LENGTH
        x, y, z = self.points.T
        twisted = np.stack(
            [
                np.cos(angle) * x - np.sin(angle) * y,
                np.sin(angle) * x + np.cos(angle) * y,
                z,
            ],
            axis=1,
        )
        # The twisted triangles cut corners, by 0.12 % of the volume here.
        np.testing.assert_allclose(self.slices.ratios(twisted), 1, atol=2e-3)

    def test_what_moves_along_the_muscle_is_seen(self):
        thicker = self.points.copy()
        half = thicker[:, 2] > LENGTH / 2
        thicker[half, :2] *= np.sqrt(1.2)
        ratios = self.slices.ratios(thicker)[0]
        np.testing.assert_allclose(ratios[:4], 1, rtol=ROUNDING * 100)
        np.testing.assert_allclose(ratios[6:], 1.2, rtol=1e-6)

    def test_volumes_add_up(self):
        bent = self.points + np.outer(self.points[:, 2] ** 2, [0.01, 0, 0])
        volumes = self.slices.volumes(bent)
        np.testing.assert_allclose(
            volumes.sum(axis=1), self.slices.at_rest.sum(axis=1), rtol=1e-6
        )


class CourseTest(unittest.TestCase):
    def test_lines_that_run_backwards_are_turned(self):
        lines = [np.array([[0, 0, 0], [0, 0, 3.0]]), np.array([[1, 0, 2.0], [1, 0, 0]])]
        np.testing.assert_allclose(course(lines), ALONG)


class LoopsTest(unittest.TestCase):
    def test_two_loops(self):
        self.assertEqual(loops_of([2, 3, 0, 4, 1]).tolist(), [0, 1, 0, 1, 1])


if __name__ == "__main__":
    unittest.main()
