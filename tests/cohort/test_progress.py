#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Every job that ends is told once, failed ones with the reason and the log."""
import json
import unittest

from folder import FolderTest
from musclewarp_cohort.progress import Progress, SnakemakeLog
from musclewarp_cohort.table import Job

PLAN = """\
Building DAG of jobs...
Job stats:
job       count
------  -------
deform        2
total         2

"""
BEGINS = """\
[Sat Nov 28 05:55:49 2026]
rule deform:
    input: /in/{0}/motion.json, /in/{0}/hip.mot
    output: {0}/hip/job.json
    jobid: 0
    reason: Missing output files: {0}/hip/job.json
    wildcards: participant={0}, motion=hip

"""
FAILS = """\
[Sat Nov 28 05:55:50 2026]
Error in rule deform:
    jobid: 0
    output: {0}/hip/job.json
    shell:
        python3 -m musclewarp_cohort.job

"""


class ProgressTest(FolderTest):

    def setUp(self):
        super().setUp()
        self.out.mkdir()
        self.log = self.out / "snakemake.log"
        self.log.write_text("")
        self.said = []

    def progress(self, *names):
        return Progress([Job(name, "hip", "s.json") for name in names], self.out,
                        self.log, self.said.append)

    def write(self, text):
        with open(self.log, "a", encoding="utf-8") as file:
            file.write(text)

    def ends(self, name, code=0, reason=""):
        folder = self.out / name / "hip"
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "job.json").unlink(missing_ok=True)  # as Snakemake does
        (folder / "job.json").write_text(json.dumps(
            {"exit_code": code, "reason": reason, "memory_mb": 1}))

    def test_jobs_are_told_once_as_they_end(self):
        progress = self.progress("a", "b")
        self.write(PLAN + BEGINS.format("a") + BEGINS.format("b"))
        progress.look()
        told = [len(self.said)]
        self.ends("b")
        progress.look()
        told.append(len(self.said))
        self.ends("a", 2, "no mesh")
        progress.look()
        told.append(len(self.said))
        progress.end(0, False)
        self.assertEqual([1, 2, 3], told)
        self.assertEqual([
            f"2 of 2 jobs to do; what Snakemake says: {self.log}",
            "[1 of 2] b hip: usable",
            f"[2 of 2] a hip: refused: no mesh; see {self.out}/a/hip/job.log"],
            self.said)

    def test_what_was_done_before_is_not_told(self):
        for name in ("a", "b", "c"):
            self.ends(name)
        progress = self.progress("a", "b", "c")
        progress.look()
        self.ends("b")
        self.write(PLAN)
        progress.end(0, False)
        self.assertEqual(["2 of 3 jobs to do; what Snakemake says: "
                          f"{self.log}", "[1 of 2] b hip: usable"], self.said)

    def test_jobs_without_a_record_are_told_from_the_log(self):
        progress = self.progress("a", "b")
        (self.out / "a/hip").mkdir(parents=True)
        (self.out / "a/hip/job.log").write_text("musclewarp-cohort: killed by SIGKILL")
        self.write(PLAN + BEGINS.format("a") + FAILS.format("a"))
        progress.end(1, False)
        self.assertEqual([
            "[1 of 2] a hip: not finished: killed by SIGKILL; see "
            f"{self.out}/a/hip/job.log",
            f"Snakemake ended with exit code 1; what it said is in {self.log}"],
            self.said[1:])

    def test_a_failure_of_snakemake_itself_is_shown(self):
        progress = self.progress("a")
        self.write("Building DAG of jobs...\nMissingInputException: no a.ply\n\n")
        progress.end(1, False)
        self.assertIn(str(self.log), self.said[0])
        self.assertEqual("  MissingInputException: no a.ply", self.said[-1])

    def test_jobs_that_the_log_does_not_announce_are_told_in_the_end(self):
        progress = self.progress("a")
        self.ends("a")
        self.write("some other words\n")
        progress.end(0, False)
        self.assertEqual("[1 of 1] a hip: usable", self.said[0])

    def test_nothing_to_do(self):
        self.ends("a")
        progress = self.progress("a")
        self.write("Nothing to be done (all requested files are present).\n")
        progress.end(0, True)
        self.assertEqual(["0 of 1 jobs to do; what Snakemake says: "
                          f"{self.log}"], self.said)

    def test_dry_run_names_jobs_and_reasons(self):
        progress = self.progress("a", "b")
        self.write(PLAN + BEGINS.format("a") + BEGINS.format("b"))
        progress.end(0, True)
        self.assertEqual(
            [f"would run {name} hip (Missing output files: {name}/hip/job.json)"
             for name in "ab"], self.said[1:])

    def test_the_log_is_read_however_it_is_cut(self):
        text = PLAN + BEGINS.format("a") + FAILS.format("a") + BEGINS.format("b")
        log = SnakemakeLog(self.log)
        for place in range(0, len(text), 7):
            self.write(text[place:place + 7])
            log.read()
        self.assertEqual((2, ["a/hip"], ["a/hip", "b/hip"]),
                         (log.planned, log.failed,
                          [folder for folder, _ in log.announced]))

    def test_what_earlier_calls_said_does_not_count(self):
        self.write(PLAN + FAILS.format("a"))
        log = SnakemakeLog(self.log)
        log.read()
        self.assertEqual((None, []), (log.planned, log.failed))


if __name__ == "__main__":
    unittest.main()
