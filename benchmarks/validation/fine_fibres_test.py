# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""/usr/bin/python3 -m unittest discover -s benchmarks/validation -p '*_test.py'"""

import unittest

import numpy as np

from fine_fibres import MeanValues, differenced, lengths_of
from slices_test import spindle

TURN = np.array([[0.0, -0.6, 0.8], [1.0, 0.0, 0.0], [0.0, 0.8, 0.6]])  # a rotation


def inner_points():
    """Points in the spindle, some of them near its surface, and one outside."""
    z = np.linspace(15, 85, 40)
    radius = np.linspace(0, 0.95, 40) * (2 + 10 * np.sin(np.pi * z / 100))
    angle = 2.4 * np.arange(40)
    inside = np.stack([radius * np.cos(angle), radius * np.sin(angle), z], axis=1)
    return np.concatenate([inside, [[30, 5, 50]]])


class MeanValuesTest(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = spindle()
        self.mesh = MeanValues(self.points, self.triangles)

    def test_linear_functions_are_reproduced(self):
        queries = inner_points()
        rows = self.mesh.coordinates(queries)
        np.testing.assert_allclose(rows.sum(axis=1), 1, rtol=1e-13)
        np.testing.assert_allclose(rows @ self.points, queries, atol=1e-9)
        matrix, shift = np.array([[1, 2, 0], [0, 1, 3], [5, 0, 1]]), [1, 2, 3]
        moved = self.points @ matrix + shift
        np.testing.assert_allclose(rows @ moved, queries @ matrix + shift, atol=1e-8)

    def test_a_vertex_has_the_point_on_it(self):
        row = self.mesh.coordinates(self.points[[100]])[0]
        np.testing.assert_array_equal(row, np.arange(len(self.points)) == 100)

    def test_corners_share_a_point_on_their_triangle(self):
        corners = self.triangles[300]
        shares = np.array([0.5, 0.3, 0.2])
        row = self.mesh.coordinates(shares[None] @ self.points[corners])[0]
        np.testing.assert_allclose(row[corners], shares, rtol=1e-9)
        self.assertAlmostEqual(np.abs(row).sum(), 1)

    def test_coordinates_are_continuous_at_the_surface(self):
        corners = self.points[self.triangles[300]]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        on_it = corners.mean(axis=0)
        steps = np.array([[0], [1e-12], [1e-9], [1e-6]]) / np.linalg.norm(normal)
        rows = self.mesh.coordinates(on_it - steps * normal)
        np.testing.assert_allclose(rows[1:], rows[[0, 0, 0]], atol=1e-5)

    def test_corners_of_a_tetrahedron_have_barycentric_coordinates(self):
        points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
        triangles = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
        row = MeanValues(points, triangles).coordinates(np.array([[0.1, 0.2, 0.3]]))
        np.testing.assert_allclose(row, [[0.4, 0.1, 0.2, 0.3]])

    def test_rigid_motions_keep_lengths(self):
        queries, sizes = inner_points(), np.array([20, 21])
        moved = self.mesh.coordinates(queries) @ (self.points @ TURN.T + [7, 8, 9])
        np.testing.assert_allclose(
            lengths_of(moved, sizes), lengths_of(queries, sizes), rtol=1e-12
        )


class LengthsTest(unittest.TestCase):
    def test_what_lies_between_polylines_does_not_count(self):
        points = np.array([[0, 0, 0], [3, 4, 0], [100, 0, 0], [100, 0, 1], [100, 2, 1]])
        self.assertEqual(lengths_of(points, np.array([2, 3])).tolist(), [5, 3])


class DifferencedTest(unittest.TestCase):
    def test_a_length_that_grows_evenly_has_a_constant_arm(self):
        angles = np.array([-10.0, -8, -6, -4])
        lengths = np.outer(np.radians(angles), [30.0, -5]) + [100, 200]
        np.testing.assert_allclose(
            differenced(lengths, angles), np.tile([-30.0, 5], (4, 1))
        )


if __name__ == "__main__":
    unittest.main()
