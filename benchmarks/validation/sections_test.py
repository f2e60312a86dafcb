# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""/usr/bin/python3 -m unittest discover -s benchmarks/validation -p '*_test.py'"""

import unittest

import numpy as np

from bellies import above
from sections import areas_along, middle_line, peak_of, plane_area, thickness
from slices import volume_of
from slices_test import ALONG, AROUND, LENGTH, spindle

POLYGON = AROUND / 2 * np.sin(2 * np.pi / AROUND)  # its area over a radius squared
AXIS = np.array([[0, 0, 0], [0, 0, LENGTH]], float)


def radius(z):
    """That of spindle() where it has a ring."""
    return 2 + 10 * np.sin(np.pi * z / LENGTH)


class SectionsTest(unittest.TestCase):
    def setUp(self):
        self.points, self.triangles = spindle()

    def test_a_plane_cuts_a_polygon(self):
        height = self.points[20 * AROUND, 2]
        found = plane_area(self.points, self.triangles, ALONG, np.array([0, 0, height]))
        self.assertAlmostEqual(found, POLYGON * radius(height) ** 2, places=6)

    def test_an_oblique_plane_cuts_more(self):
        tilted = np.array([0, 0.6, 0.8])
        place = np.array([0, 0, LENGTH / 2])
        found = plane_area(self.points, self.triangles, tilted, place)
        across = plane_area(self.points, self.triangles, ALONG, place)
        # It is 1 / 0.8 of a cylinder, and less of what tapers.
        self.assertAlmostEqual(found / across, 1 / 0.8, delta=0.05)

    def test_a_plane_beside_it_cuts_nothing(self):
        place = np.array([0, 0, 2 * LENGTH])
        self.assertEqual(plane_area(self.points, self.triangles, ALONG, place), 0)

    def test_the_largest_section_is_in_the_middle(self):
        along, areas = areas_along(self.points, self.triangles, AXIS)
        self.assertAlmostEqual(peak_of(along, areas), LENGTH / 2, delta=0.5)
        self.assertAlmostEqual(areas.max(), POLYGON * 12**2, delta=2)

    def test_the_loop_at_the_line_counts(self):
        far = self.points + [60, 0, 0]
        both = np.concatenate([self.points, far])
        triangles = np.concatenate([self.triangles, self.triangles + len(far)])
        one = areas_along(self.points, self.triangles, AXIS)[1]
        np.testing.assert_allclose(areas_along(both, triangles, AXIS)[1], one)

    def test_the_middle_of_lines_is_between_them(self):
        middle = middle_line([AXIS, AXIS + [2, 0, 0]])
        np.testing.assert_allclose(middle[:, :2], [[1, 0]] * len(middle), atol=1e-12)
        np.testing.assert_allclose(middle[[0, -1], 2], [0, LENGTH], atol=1e-9)

    def test_thickness_from_outside_and_from_within(self):
        height = self.points[20 * AROUND, 2]
        # Through edges of the polygon, off its corners.
        direction = np.array([np.cos(0.1), np.sin(0.1), 0])
        width = 2 * radius(height) * np.cos(np.pi / AROUND) / np.cos(0.1 - np.pi / AROUND)
        centre = np.array([0, 0, height + 1e-9])
        outside = thickness(
            self.points, self.triangles, centre - 50 * direction, direction
        )
        within = thickness(self.points, self.triangles, centre, direction)
        self.assertAlmostEqual(outside, width, places=6)
        self.assertAlmostEqual(within, width / 2, places=6)


class BelliesTest(unittest.TestCase):
    def test_what_is_above_is_kept_and_closed(self):
        points, triangles = spindle()
        kept, faces = above(points, triangles, LENGTH / 2)
        self.assertAlmostEqual(kept[:, 2].min(), LENGTH / 2)
        edges = {tuple(edge) for t in faces for edge in (t[:2], t[1:], t[[2, 0]])}
        self.assertTrue(all((b, a) in edges for a, b in edges))
        half = volume_of(points, triangles) / 2
        self.assertAlmostEqual(volume_of(kept, faces), half, delta=1e-6 * half)


if __name__ == "__main__":
    unittest.main()
