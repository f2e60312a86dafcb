# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Powers that fit, and the samples that they are fitted to."""

import pathlib
import tempfile
import unittest

import growth
import log_plot
import numpy as np
import recorded

ROUNDING = 1e-9


class GrowthTest(unittest.TestCase):

    def test_power_of_exact_data_is_exact(self):
        x = np.array([2.0, 4, 8, 30])
        for power, factor in ((1.5, 3), (0, 7), (-1, 0.1)):
            found = growth.fitted_power(x, factor * x**power)
            np.testing.assert_allclose(found, (power, factor), atol=ROUNDING)

    def test_unit_changes_the_factor_only(self):
        x, y = np.array([1.0, 2, 3]), np.array([5.0, 7, 30])
        power, factor = growth.fitted_power(x, y)
        scaled = growth.fitted_power(x, 1000 * y)
        np.testing.assert_allclose(scaled, (power, 1000 * factor), rtol=ROUNDING)

    def test_one_size_has_no_power(self):
        with self.assertRaisesRegex(ValueError, "one size alone, 4"):
            growth.fitted_power(np.array([4.0, 4]), np.array([1.0, 2]))

    def test_time_of_a_step_is_that_of_frames_over_their_steps(self):
        frames = [recorded.frame(0, 1000), recorded.frame(1, 6, steps=3)]
        frames += [recorded.frame(2, 10, steps=5)]
        sample = growth.sample_of(recorded.report(frames, [100, 200]), seed=3)
        self.assertEqual(growth.Sample(3, 2, 300, "2 of 2", 8, 4, 8), sample)

    def test_plot_fits_the_power_that_the_reports_have(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            recorded.write_figures(folder)
            samples = growth.samples_of(folder, "muscles")
            self.assertEqual([2, 4, 8], [sample.muscles for sample in samples])
            plot = folder / "plot.svg"
            powers = growth.plot_growth(samples, "muscles", "Title", "muscles", plot)
            np.testing.assert_allclose(powers, (2, 2), atol=ROUNDING)
            self.assertIn("step, power 2.00", plot.read_text())
            self.assertEqual(6, plot.read_text().count("<circle"))


class LogPlotTest(unittest.TestCase):

    def test_marks_are_round_and_inside(self):
        self.assertEqual([5, 10, 20, 50, 100], log_plot.log_ticks(3, 100))
        self.assertEqual([2, 3, 4, 5, 6, 8], log_plot.log_ticks(1.8, 9))

    def test_power_law_is_a_straight_line(self):
        x = np.array([1.0, 10, 100])
        curve = log_plot.Curve("", x, x**2, "red")
        plot = log_plot.LogPlot("", "", "", [curve])
        places = [(plot._x(a), plot._y(b)) for a, b in ((0, 0), (1, 2), (2, 4))]
        np.testing.assert_allclose(
            np.add(places[0], places[2]), np.multiply(2, places[1]), rtol=ROUNDING
        )


if __name__ == "__main__":
    unittest.main()
