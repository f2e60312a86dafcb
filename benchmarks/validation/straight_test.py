# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""/usr/bin/python3 -m unittest discover -s benchmarks/validation -p '*_test.py'"""

import unittest

import numpy as np

from straight import axis_of, rigid_motion, straight_arms

AXIS = np.array([2.0, -1.0, 2.0]) / 3


def rotation(angle):
    """The rotation about AXIS by an angle."""
    x, y, z = AXIS
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


class StraightTest(unittest.TestCase):
    def setUp(self):
        random = np.random.default_rng(1)
        self.origins = random.normal(size=(3, 3)) + [0, 5, 0]
        self.insertions = random.normal(size=(4, 3)) - [0, 5, 0]
        self.centre = np.array([0.3, 0.2, 0.1])

    def lengths(self, angle):
        moved = (self.insertions - self.centre) @ rotation(angle).T + self.centre
        return np.linalg.norm(moved[None] - self.origins[:, None], axis=2).ravel()

    def test_arms_are_the_slopes_of_lengths(self):
        arms = straight_arms(self.origins, self.insertions, AXIS, self.centre)
        step = 1e-5
        slopes = (self.lengths(step) - self.lengths(-step)) / (2 * step)
        np.testing.assert_allclose(arms, -slopes, atol=1e-8)

    def test_the_arm_of_a_line_across_the_axis_is_its_distance(self):
        arms = straight_arms(
            np.array([[3.0, 10, 0]]),
            np.array([[3.0, -10, 0]]),
            np.array([0, 0, 1.0]),
            np.zeros(3),
        )
        # In front of a joint (x) whose axis points to the right (z): it flexes.
        np.testing.assert_allclose(arms, [3])

    def test_motion_and_axis_are_found(self):
        turn, shift = rotation(0.7), np.array([1.0, 2.0, 3.0])
        found, moved = rigid_motion(self.insertions, self.insertions @ turn.T + shift)
        np.testing.assert_allclose(found, turn, atol=1e-12)
        np.testing.assert_allclose(moved, shift, atol=1e-12)
        np.testing.assert_allclose(axis_of(found), AXIS, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
