# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The tables of stages and of modes."""

import unittest

import modes
import recorded
import stages


def rows_of(table):
    rows = [line.strip("| ").split(" | ") for line in table.splitlines()[2:]]
    return {row[0].strip("*"): row[1:] for row in rows}


class StageTableTest(unittest.TestCase):

    def test_names_every_stage_of_either_run_and_every_time(self):
        one = [recorded.frame(3, stages={"start": 1, "volume": 2})]
        two = [recorded.frame(3, stages={"start": 1, "defects": 2})]
        rows = rows_of(stages.stage_table(one, two))
        self.assertEqual(
            [
                "start",
                "volume",
                "defects",
                "moving",
                "certificate and measures",
                "moment arms",
            ],
            list(rows),
        )

    def test_ratio_is_that_of_one_thread_to_two(self):
        one, two = ([recorded.frame(3, ms)] for ms in (30.0, 20.0))
        for name, row in rows_of(stages.stage_table(one, two)).items():
            self.assertEqual("1.50", row[2], name)

    def test_frame_that_leaves_a_stage_out_spends_nothing_there(self):
        frames = [recorded.frame(3, stages={"volume": 8})]
        frames += [recorded.frame(index, stages={}) for index in (4, 5)]
        self.assertEqual({"volume": 0}, stages.stage_times(frames))


class ModeTableTest(unittest.TestCase):

    def test_ratios_are_to_the_sum_of_muscles_with_cgal(self):
        cgal = modes.cgal_turns([recorded.solve(4), recorded.solve(6)])
        self.assertEqual([8, 12], cgal)
        times = {(mode, n): [20, 30 - n] for mode in modes.MODES for n in (1, 2)}
        rows = rows_of(modes.mode_table(times, cgal))
        self.assertEqual(len(modes.MODES) + 1, len(rows))
        self.assertEqual("2.45", rows["`--contact=none`"][1])
        self.assertEqual("1.00", rows["CGAL, as rigid as possible"][1])

    def test_muscles_have_means_of_the_turns(self):
        rows = rows_of(modes.muscle_table([recorded.solve(4), recorded.solve(6)]))
        self.assertEqual(["psoas major", "iliacus"], list(rows))
        self.assertEqual(["100, 20", *3 * ["5.0"], "1.0", "1.00"], rows["iliacus"])


if __name__ == "__main__":
    unittest.main()
