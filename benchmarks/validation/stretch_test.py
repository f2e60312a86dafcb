# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""/usr/bin/python3 -m unittest discover -s benchmarks/validation -p '*_test.py'"""

import unittest

import numpy as np

from stretch import PARTS, part_stretches


def along(places):
    """Points at these places along an oblique line."""
    return np.outer(places, [0.6, 0.0, 0.8])


class PartStretchesTest(unittest.TestCase):
    def test_rest_is_not_stretched(self):
        rest = along([0, 1, 5, 6, 10])
        np.testing.assert_allclose(part_stretches(rest, rest + 3), 1)

    def test_the_part_that_shortens_is_seen(self):
        # The last fifth of the length, which no point but the end bounds.
        rest, moved = along([0, 4, 8, 10]), along([0, 4, 8, 9])
        np.testing.assert_allclose(part_stretches(rest, moved), [1, 1, 1, 1, 0.5])

    def test_parts_are_of_equal_length_not_of_equal_numbers_of_points(self):
        rest = along([0, 0.1, 0.2, 0.3, 0.4, 10])
        moved = along(2 * np.array([0, 0.1, 0.2, 0.3, 0.4, 10]))
        np.testing.assert_allclose(part_stretches(rest, moved), [2] * PARTS)

    def test_the_parts_add_up(self):
        rest = np.cumsum(np.random.default_rng(2).normal(size=(40, 3)), axis=0)
        moved = rest * [1.0, 1.2, 0.7]
        lengths = [
            np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
            for points in (rest, moved)
        ]
        mean = part_stretches(rest, moved).mean()
        np.testing.assert_allclose(mean, lengths[1] / lengths[0])


if __name__ == "__main__":
    unittest.main()
