#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Outliers are named where they are farthest out, by a rule that does not depend on
the order, the unit or a common offset of values."""
import unittest

from folder import SOURCE  # noqa: F401  (finds musclewarp_cohort)
from musclewarp_cohort import outliers

PLACES = (-10.0, 0.0, 10.0, 20.0)


def group(count=9):
    """Curves that are evenly spread, none of them an outlier."""
    return {f"sub-{number}": [(place, 40 + place / 10 + number * 7 % count / 4)
                              for place in PLACES] for number in range(count)}


def moved(curve, place, by):
    return [(x, y + by if x == place else y) for x, y in curve]


class OutliersTest(unittest.TestCase):

    def setUp(self):
        self.curves = group()
        self.assertEqual([], outliers.find(self.curves))
        self.curves["sub-4"] = moved(self.curves["sub-4"], 10.0, 30)

    def test_is_named_where_it_is_farthest_out(self):
        found, = outliers.find(self.curves)
        self.assertEqual(("sub-4", 10.0), (found.name, found.place))
        self.assertEqual(dict(self.curves["sub-4"])[10.0], found.value)
        at_10 = sorted(dict(curve)[10.0] for curve in self.curves.values())
        self.assertEqual(at_10[len(at_10) // 2], found.median)

    def test_the_limit_is_that_of_the_rule(self):
        """Of -2, -1, 0, 1, 2 and x the deviation is known by hand."""
        def found(x):
            values = (-2, -1, 0, 1, 2, 0, x)  # the median is 0, that of distances 1
            return [each.name for each in outliers.find(
                {str(place): [(0, 10 + value)]
                 for place, value in enumerate(values)})]

        limit = 3.5 * 1.4826
        self.assertEqual([], found(0.999 * limit))
        self.assertEqual(["6"], found(1.001 * limit))

    def test_order_unit_and_offset_do_not_matter(self):
        expected = [(each.name, each.place) for each in outliers.find(self.curves)]
        for curves in (
                dict(reversed(self.curves.items())),
                {name: [(x, -3 * y) for x, y in curve]
                 for name, curve in self.curves.items()},
                {name: [(x, y + 7) for x, y in curve]
                 for name, curve in self.curves.items()}):
            self.assertEqual(expected, [(each.name, each.place)
                                        for each in outliers.find(curves)])

    def test_few_have_none(self):
        for count in range(1, outliers.FEWEST):
            curves = group(count)
            curves["sub-0"] = moved(curves["sub-0"], 0.0, 1000)
            self.assertEqual([], outliers.find(curves))

    def test_those_who_are_all_but_alike_are_none(self):
        """Without spread every other value would be infinitely far out."""
        curves = {f"sub-{number}": [(0, 40.0)] for number in range(6)}
        curves["sub-0"] = [(0, 40.0 * (1 + 0.9 * outliers.LEAST_SHARE))]
        self.assertEqual([], outliers.find(curves))
        curves["sub-0"] = [(0, 40.0 * (1 + 1.1 * outliers.LEAST_SHARE))]
        self.assertEqual(["sub-0"], [each.name for each in outliers.find(curves)])

    def test_other_frames_of_the_same_curve_are_no_difference(self):
        """Of curves that are straight between frames."""
        whole = [(place, 2.0 * place) for place in range(0, 41, 10)]
        curves = {f"sub-{number}": whole for number in range(6)}
        curves["sub-6"] = whole[::2]
        curves["sub-7"] = [(place + 5, 2.0 * place + 10) for place in range(0, 31, 10)]
        self.assertEqual([], outliers.find(curves))
        self.assertEqual(whole, outliers.medians(curves))

    def test_no_common_frames(self):
        curves = {f"sub-{number}": [(number / 10 + 10 * step, 5.0) for step in range(5)]
                  for number in range(6)}
        places = outliers.places_of(curves)
        self.assertEqual(outliers.MOST_PLACES, len(places))
        curves["sub-3"] = [(x, 9.0) for x, _ in curves["sub-3"]]
        self.assertEqual(["sub-3"], [each.name for each in outliers.find(curves)])
        self.assertEqual([], outliers.places_of(curves, interpolate=False))

    def test_between_frames_is_nothing_without_interpolation(self):
        curve = [(0, 1.0), (10, 3.0)]
        self.assertEqual(2.0, outliers.value_at(curve, 5, 0))
        self.assertIsNone(outliers.value_at(curve, 5, 0, interpolate=False))
        for outside in (-1, 11):
            self.assertIsNone(outliers.value_at(curve, outside, 0))

    def test_many_places_are_thinned_with_their_ends(self):
        curves = {f"sub-{number}": [(place, 1.0) for place in range(1000)]
                  for number in range(5)}
        places = outliers.places_of(curves)
        self.assertEqual((0, 999, outliers.MOST_PLACES),
                         (places[0], places[-1], len(set(places))))


if __name__ == "__main__":
    unittest.main()
