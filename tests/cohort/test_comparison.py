#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The page says which subjects are far from the others, where and of how many, and
what could not be compared."""
import html
import re
import unittest

from folder import SOURCE, balanced  # noqa: F401
from musclewarp_cohort import comparison, outliers, plots
from musclewarp_cohort.curves import LENGTH, VOLUME, Measured, Quantity

LENGTH_OF_PSOAS = Quantity("psoas", LENGTH, "psoas_r", unit="mm")
VOLUME_OF_PSOAS = Quantity("psoas", VOLUME, unit="cm3")
ANGLES = (0.0, 30.0, 60.0)


def subject(number, by=0.0, volume=250.0):
    """A subject whose psoas is longer than that of others at 30 degrees."""
    values = {index: 200 + number / 10 + angle / 10 + (by if angle == 30 else 0)
              for index, angle in enumerate(ANGLES)}
    return Measured(
        f"sub-{number}", "walk", {"hip_flexion_r": "degrees"},
        {index: {"hip_flexion_r": angle} for index, angle in enumerate(ANGLES)},
        ("psoas",), {VOLUME_OF_PSOAS: volume + number}, {LENGTH_OF_PSOAS: values})


def cells(text):
    """The rows of the table of outliers, as text."""
    rows = re.findall(r"<tr>(<td.*?)</tr>", text)
    return [[html.unescape(re.sub("<.*?>", "", cell))
             for cell in re.findall("<td.*?</td>", row)] for row in rows]


class ComparisonTest(unittest.TestCase):

    def test_outliers_are_listed(self):
        runs = [subject(number) for number in range(6)]
        runs += [subject(6, by=25), subject(7, volume=500)]
        text = comparison.as_html(runs)
        self.assertEqual([
            ["sub-6", "psoas", "length of psoas_r", "hip_flexion_r 30 degrees",
             "228.6", "203.4", "mm"],
            ["sub-7", "psoas", "volume", "at rest", "507", "253.5", "cm3"]],
            cells(text))
        self.assertIn(html.escape(outliers.RULE), text)
        self.assertEqual(1, text.count('<polyline class="out"'))
        self.assertEqual(1, text.count('<circle class="dot out"'))
        balanced(self, text)

    def test_units_are_on_the_axes(self):
        text = comparison.as_html([subject(number) for number in range(5)])
        self.assertIn("hip_flexion_r, degrees</text>", text)
        self.assertIn("length of psoas_r, mm</figcaption>", text)
        self.assertIn("volume, cm3</figcaption>", text)
        self.assertIn("<p>No outliers. 2 of 2 quantities", text)

    def test_few_subjects(self):
        text = comparison.as_html([subject(0), subject(1, by=1000)])
        self.assertIn("No outliers are sought among 2 runs; it takes 5.", text)
        self.assertNotIn("class=\"out\"", text)

    def test_what_cannot_be_compared_is_counted_and_named(self):
        runs = [subject(number) for number in range(5)]
        lacks = subject(5)
        lacks.muscles, lacks.volumes, lacks.curves = (), {}, {}
        text = comparison.as_html([*runs, lacks, Measured("sub-9", "walk")])
        self.assertIn("6 of 7 runs are compared. 1 has no usable frames: sub-9.", text)
        self.assertIn("5 of 6 runs have it; 1 lacks it: sub-5.", text)
        self.assertIn("length of psoas_r, mm (5 of 6 runs)", text)

    def test_nothing_to_compare(self):
        self.assertEqual("", comparison.as_html([Measured("sub-9", "walk")]))

    def test_motions_are_compared_by_themselves(self):
        runs = [subject(number) for number in range(5)]
        other = subject(6, by=1000)
        other.motion = "squat"
        text = comparison.as_html([*runs, other])
        self.assertEqual([], cells(text))
        self.assertIn("<h2>Muscles over subjects: squat</h2>", text)

    def test_names_are_escaped(self):
        run = subject(0)
        run.participant = "<b>"
        self.assertNotIn("<b>", comparison.as_html([run]))

    def test_many_subjects_are_a_range(self):
        runs = [subject(number) for number in range(plots.MOST_CURVES + 1)]
        text = comparison.as_html([*runs, subject(99, by=500)])
        self.assertEqual(1, text.count("<polygon"))
        self.assertEqual(["median", "out"],
                         re.findall('<polyline class="(.*?)"', text))

    def test_everything_is_within_its_plot(self):
        text = comparison.as_html([subject(number) for number in range(7)] +
                                  [subject(7, by=-900)])
        for points in re.findall('points="(.*?)"', text):
            for point in points.split():
                x, y = map(float, point.split(","))
                self.assertTrue(plots.SIDE <= x <= plots.RIGHT, point)
                self.assertTrue(plots.TOP <= y <= plots.BOTTOM, point)


if __name__ == "__main__":
    unittest.main()
