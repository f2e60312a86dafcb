#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Curves are those of usable frames, over the coordinate that alone moves."""
import unittest

from folder import frame, report
from musclewarp_cohort import curves
from musclewarp_cohort.curves import LENGTH, MOMENT_ARM, Axis, Quantity

KNEE = "knee_angle_r"


def run(values, usable=None, moving=((KNEE, "degrees"),), lengths=None):
    """A Measured of a muscle whose line is as long as 300 less the coordinate."""
    frames = []
    for index, value in enumerate(values):
        made = frame(index, [("vastus", 1.0, {"vasti": {KNEE: 30 + value}})],
                     usable is None or usable[index], coordinates={KNEE: value})
        made["muscles"][0]["line_lengths_mm"] = {
            "vasti": lengths[index] if lengths else 300 - value}
        frames.append(made)
    made = report(frames)
    made["prepare"]["muscles"][0]["volume_mm3"] = 250000.0
    made["motion"] = {"coordinates": [
        {"name": name, "unit": unit, "moves": True} for name, unit in moving]}
    return curves.of_report("sub-1", "bend", made)


class CurvesTest(unittest.TestCase):
    length = Quantity("vastus", LENGTH, "vasti", unit="mm")

    def test_lengths_arms_and_volumes_with_units(self):
        measured = run([0.0, 10.0])
        self.assertEqual({0: 300.0, 1: 290.0}, measured.curves[self.length])
        arm = Quantity("vastus", MOMENT_ARM, "vasti", KNEE, "mm/rad")
        self.assertEqual({0: 30.0, 1: 40.0}, measured.curves[arm])
        (volume, value), = measured.volumes.items()
        self.assertEqual(("cm3", 250.0), (volume.unit, value))

    def test_arms_of_translations_are_per_metre(self):
        measured = run([0.0, 0.1], moving=[(KNEE, "metres")])
        self.assertEqual({"mm/m"}, {each.unit for each in measured.curves
                                    if each.kind == MOMENT_ARM})

    def test_frames_that_are_not_usable_do_not_count(self):
        measured = run([0.0, 10.0, 20.0], usable=[True, False, True])
        self.assertEqual([(0.0, 300.0), (20.0, 280.0)], curves.points(
            measured, self.length, Axis(KNEE, "degrees")))
        self.assertEqual({}, run([0.0], usable=[False]).frames)
        self.assertEqual({}, curves.of_report("sub-1", "bend", None).frames)

    def test_arms_that_did_not_converge_do_not_count(self):
        bad = frame(0, [("vastus", 1.0, {"vasti": {KNEE: 30.0}})],
                    moment_arms_converged=False)
        self.assertEqual({}, curves.of_report("sub-1", "bend", report([bad])).curves)
        none = frame(0, [("vastus", 1.0, {"vasti": {KNEE: None}})])
        self.assertEqual({}, curves.of_report("sub-1", "bend", report([none])).curves)

    def test_curves_ascend_however_the_coordinate_moves(self):
        measured = run([20.0, 10.0, 0.0])
        axis = curves.axis_of([measured, run([0.0, 5.0])])
        self.assertEqual("knee_angle_r, degrees", axis.label())
        points = curves.points(measured, self.length, axis)
        self.assertEqual([(0.0, 300.0), (10.0, 290.0), (20.0, 280.0)], points)

    def test_axis_is_the_frame_where_a_value_is_not_one_frame(self):
        once = run([0.0, 10.0])
        for other in (run([0.0, 10.0, 0.0]),
                      run([0.0, 10.0], moving=[(KNEE, "degrees"), ("x", "metres")]),
                      run([0.0, 10.0], moving=[]),
                      run([0.0, 10.0], moving=[("hip", "degrees")])):
            self.assertEqual("frame", curves.axis_of([once, other]).label())
        self.assertEqual([(0, 300.0), (1, 290.0)],
                         curves.points(once, self.length, Axis()))

    def test_runs_without_frames_have_no_say(self):
        lost = curves.of_report("sub-2", "bend", None)
        self.assertEqual(KNEE, curves.axis_of([lost, run([0.0, 10.0])]).name)


if __name__ == "__main__":
    unittest.main()
