#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""A job says how musclewarp-deform ended, and begins anew only if its input has
changed."""
import json
import signal
import threading
import unittest

from folder import FolderTest, frame, report
from musclewarp_cohort import files, job
from musclewarp_cohort.table import Job

MUSCLE = ("psoas", 1.0, {})
USABLE = report([frame(0, [MUSCLE])])


class JobTest(FolderTest):

    def play(self, **how):
        return str(self.file("scene.json", json.dumps(how)))

    def run_job(self, scene, **more):
        return job.run(Job("sub-1", "scene", scene, **more), self.out,
                       str(self.deform), 2)

    def expect_no_result(self, scene, why):
        self.assertEqual(1, self.run_job(scene))
        self.assertFalse((self.out / job.RECORD).exists())
        self.assertIn(why, job.last_line(self.out / job.LOG))

    def leave_report(self, left):
        """A report.json of an earlier run."""
        self.out.mkdir(exist_ok=True)
        (self.out / "report.json").write_text(json.dumps(left))

    def record(self):
        return json.loads((self.out / job.RECORD).read_text())

    def runs(self):
        """The command lines since the folder was last cleared."""
        return (self.out / "runs.txt").read_text().splitlines()

    def test_usable(self):
        self.assertEqual(0, self.run_job(self.play(report=USABLE)))
        record = self.record()
        self.assertEqual((0, ""), (record["exit_code"], record["reason"]))
        self.assertGreater(record["memory_mb"], 1)

    def test_command_line(self):
        self.run_job(self.play(), motion_file="/m/walk.mot", flags=("--gap=0.2",))
        line = self.runs()[0]
        for word in (f"--data_root={self.source}", "--motion=/m/walk.mot", "--html",
                     "--gap=0.2", "--threads=2", "--resume"):
            self.assertIn(word, line)

    def test_a_part_is_given_as_frames(self):
        self.assertNotIn("--frames", " ".join(job.command(
            Job("a", "scene", "s.json", parts=3), self.out, "deform", 1)))
        self.assertIn("--frames=2/3", job.command(
            Job("a", "scene", "s.json", parts=3, part=2), self.out, "deform", 1))

    def test_model_and_side_go_into_a_scene(self):
        scene = self.play(side="right", axes="LPS")
        self.run_job(scene, model="/m/hip.osim", side="left")
        made = self.out / "scene.json"
        self.assertEqual({"side": "left", "axes": "LPS", "model": "/m/hip.osim"},
                         json.loads(made.read_text()))
        self.assertIn(f"--scene={made}", self.runs()[0])
        self.assertIn(f"--data_root={self.source}", self.runs()[0])

    def test_refused(self):
        code = self.run_job(self.play(
            exit=2, says="musclewarp-deform: psoas.ply: line 2: no; export again"))
        self.assertEqual(0, code)
        record = self.record()
        self.assertEqual((2, "psoas.ply: line 2: no; export again"),
                         (record["exit_code"], record["reason"]))

    def test_not_usable(self):
        frames = [frame(0, [MUSCLE]),
                  frame(1, [MUSCLE], False, shortcomings=["too near", "folded"]),
                  frame(2, [MUSCLE], False, stop_reason="time-out")]
        self.assertEqual(0, self.run_job(self.play(exit=1, report=report(frames))))
        self.assertEqual("2 of 3 frames not usable, first 1 (step_1): too near; "
                         "folded", self.record()["reason"])

    def test_killed_is_no_result(self):
        self.expect_no_result(self.play(signal=signal.SIGKILL),
                              "killed by SIGKILL; run again")

    def test_interrupted_is_no_result(self):
        """A run that was stopped half-way ends with 1, as one that is not usable."""
        stopped = report([frame(0, [MUSCLE])], finished=False, stopped="disk full")
        self.expect_no_result(self.play(exit=1, report=stopped), "disk full")

    def test_exit_code_0_is_not_enough(self):
        bad = report([frame(0, [MUSCLE], False)])
        unfinished = report([frame(0, [MUSCLE])], finished=False)
        for made, why in (({}, "wrote no report.json"), ([], "wrote no report.json"),
                          ({"summary": 1}, "wrote no report.json"),
                          (bad, "does not say that the run is usable"),
                          (unfinished, "says that the run is not finished")):
            self.expect_no_result(self.play(report=made), why)
        self.expect_no_result(self.play(), "musclewarp-deform ended with exit code "
                              "0, but it wrote no report.json; check the program")

    def test_a_report_of_an_earlier_run_is_no_result(self):
        self.leave_report(USABLE)
        self.expect_no_result(self.play(), "wrote no report.json")
        self.leave_report(report([frame(0, [MUSCLE], False)]))
        self.expect_no_result(self.play(exit=1, says="interrupted"), "interrupted")

    def test_a_record_of_an_earlier_run_does_not_stay(self):
        self.run_job(self.play(report=USABLE))
        self.assertEqual(0, self.record()["exit_code"])
        (self.out / ".inputs").unlink()
        self.expect_no_result(self.play(), "wrote no report.json")

    def test_a_run_that_was_finished_already_is_usable(self):
        """Its report is of the same input, as musclewarp-deform has checked."""
        self.leave_report(USABLE)
        said = f"finished already: {self.out}/report.json"
        self.assertEqual(0, self.run_job(self.play(says=said)))
        self.assertEqual((0, ""), (self.record()["exit_code"],
                                   self.record()["reason"]))

    def test_same_input_goes_on(self):
        scene = self.play()
        self.run_job(scene)
        self.run_job(scene)
        self.assertEqual(2, len(self.runs()))

    def test_other_input_begins_anew(self):
        scene = self.play()
        self.run_job(scene)
        mesh = self.file("psoas.ply", "one")
        for change in ({"flags": ("--gap=0.3",)}, {"side": "left"}):
            self.run_job(scene, **change)
            self.assertEqual(1, len(self.runs()), change)
        scene = self.play(muscles=[{"mesh": "psoas.ply"}])
        self.run_job(scene)
        mesh.write_text("two")
        self.run_job(scene)
        self.assertEqual(1, len(self.runs()))

    def test_what_others_wrote_is_left_alone(self):
        self.out.mkdir()
        (self.out / "notes.txt").write_text("mine")
        self.run_job(self.play())
        self.assertEqual("mine", (self.out / "notes.txt").read_text())

    def test_waits_for_a_run_that_lives_on(self):
        self.out.mkdir()
        lock, done = self.out / job.LOCK, []

        def wait():
            with files.locked(lock, wait=True):
                done.append(True)

        with files.locked(lock, wait=True):
            with self.assertRaises(BlockingIOError):
                with files.locked(lock, wait=False):
                    pass
            waiting = threading.Thread(target=wait)
            waiting.start()
            waiting.join(0.2)
            self.assertEqual([], done)
        waiting.join(10)
        self.assertEqual([True], done)

    def test_last_line(self):
        for text, last in (("one\nframe 1\rframe 2\r\n\n", "frame 2"), ("one\n \n", "one"),
                           ("a\rframe 2\n", "frame 2"), ("", "")):
            self.assertEqual(last, job.last_line(self.file("log", text)))
        self.assertEqual("", job.last_line(self.source / "none"))


if __name__ == "__main__":
    unittest.main()
