#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The table and the page of a group hold what the jobs wrote."""
import json
import unittest

from folder import FolderTest, balanced, frame, report
from musclewarp_cohort import group, page, plots
from musclewarp_cohort.table import Job

ARMS = [{"psoas_r": {"hip_flexion_r": arm}} for arm in (30.0, 42.5, 28.0)]


class GroupTest(FolderTest):

    def result(self, name, record=None, made=None, log=None):
        folder = self.out / name / "scene"
        folder.mkdir(parents=True)
        if record:
            (folder / "job.json").write_text(json.dumps(
                {"reason": "", "wall_s": 1, "memory_mb": 70, **record}))
        if made:
            (folder / "report.json").write_text(json.dumps(made))
            (folder / "report.html").write_text("<p>")
        if log:
            (folder / "job.log").write_text(log)
        return group.read_run(Job(name, "scene", "s.json"), self.out)[0]

    def usable(self, name="sub-1"):
        frames = [frame(index, [("psoas", ratio, arms), ("iliacus", 1.0, {})],
                        gaps=[{"a": "psoas", "b": "femur", "at_least_mm": gap}])
                  for index, (ratio, arms, gap) in enumerate(zip(
                      (1 + 2 ** -30, 1 - 2 ** -28, 1.0), ARMS, (0.3, 0.2, 0.4)))]
        return self.result(name, {"exit_code": 0}, report(frames))

    def test_figures_of_a_muscle(self):
        psoas, iliacus = self.usable()
        self.assertEqual(("psoas", "usable", 0, 3, 3, 0),
                         (psoas.muscle, psoas.status, psoas.exit_code, psoas.frames,
                          psoas.usable_frames, psoas.crossings))
        self.assertEqual(2 ** -28, psoas.max_volume_error)
        self.assertEqual(0.2, psoas.least_gap_mm)
        self.assertEqual({("psoas_r", "hip_flexion_r"): (28.0, 42.5)},
                         psoas.moment_arms_mm)
        self.assertEqual((2.0, 0.75, 70), (psoas.prepare_s, psoas.frames_s,
                                           psoas.memory_mb))
        self.assertIsNone(iliacus.least_gap_mm)  # farther than 2 mm from all

    def test_crossings_of_a_muscle(self):
        pairs = [{"a": "psoas", "b": "iliacus", "triangle_pairs": 3,
                  "vertices_inside": 2},
                 {"a": "femur", "b": "iliacus", "triangle_pairs": 10,
                  "vertices_inside": 0}]
        frames = [frame(0, [("psoas", 1.0, {}), ("iliacus", 1.0, {})], False,
                        intersections={"pairs": pairs}) for _ in range(2)]
        psoas, iliacus = self.result("sub-1", {"exit_code": 1, "reason": "cross"},
                                     report(frames))
        self.assertEqual((10, 30), (psoas.crossings, iliacus.crossings))
        self.assertEqual(("not usable", "cross"), (psoas.status, psoas.reason))

    def test_runs_without_results(self):
        refused, = self.result("sub-1", {"exit_code": 2, "reason": "no\tmesh"})
        killed, = self.result("sub-2", log="x\nmusclewarp-cohort: killed by SIGKILL\n")
        waiting, = self.result("sub-3")
        self.assertEqual(["refused", "not finished", "not finished"],
                         [refused.status, killed.status, waiting.status])
        self.assertEqual("killed by SIGKILL", killed.reason)
        self.assertEqual("did not start; run again", waiting.reason)
        header, *lines = group.as_tsv([refused, killed, waiting]).splitlines()
        columns = header.split("\t")
        for line in lines:
            self.assertEqual(len(columns), len(line.split("\t")))
        self.assertEqual("no mesh", lines[0].split("\t")[columns.index("reason")])
        self.assertEqual("n/a", lines[1].split("\t")[columns.index("exit_code")])

    def test_killed_after_some_frames(self):
        """Frames of a run that has not ended are told, but it is not usable."""
        row, = self.result("sub-1", None, report([frame(0, [("psoas", 1.0, {})])],
                                                 finished=False), "deforming\n")
        self.assertEqual(("not finished", 1, "deforming"),
                         (row.status, row.frames, row.reason))

    def test_a_divided_run_is_one_run(self):
        """Its figures are those of all parts, its end is the worst of theirs."""
        run = Job("sub-1", "scene", "s.json", parts=3)
        for part, record in zip(run.divided(), (
                {"exit_code": 0}, {"exit_code": 1, "reason": "too near"}, None)):
            made = report([frame(part.part, [("psoas", 1.0, {})])])
            self.result(f"sub-1/scene/part_000{part.part}", record, made)
            folder = self.out / part.folder
            for file in (folder / "scene").iterdir():
                file.rename(folder / file.name)
        row, = group.read_run(run, self.out)[0]
        self.assertEqual(("not finished", 3, 6.0, 0.75), (
            row.status, row.frames, row.prepare_s, row.frames_s))
        self.assertEqual("2 of 3 parts, such as 3: did not start; run again",
                         row.reason)
        (self.out / run.divided()[2].folder / "job.json").write_text(
            '{"exit_code": 0, "reason": "", "memory_mb": 90}')
        row, = group.read_run(run, self.out)[0]
        self.assertEqual(("not usable", 90, "1 of 3 parts, such as 2: too near"),
                         (row.status, row.memory_mb, row.reason))

    def test_what_is_no_report_has_no_figures(self):
        for place, made in enumerate(([1], {"summary": {}}, {"prepare": 1})):
            row, = self.result(f"sub-{place}", None, made, "deforming\n")
            self.assertEqual(("not finished", None), (row.status, row.frames))

    def test_table(self):
        header, psoas, _ = group.as_tsv(self.usable()).splitlines()
        self.assertEqual(
            dict(zip(header.split("\t"), psoas.split("\t"))),
            {"participant_id": "sub-1", "motion": "scene", "muscle": "psoas",
             "status": "usable", "exit_code": "0", "frames": "3",
             "usable_frames": "3", "crossings": "0",
             "max_volume_error": "3.72529e-09", "least_gap_mm": "0.2",
             "moment_arms_mm": "psoas_r.hip_flexion_r=28:42.5", "prepare_s": "2",
             "frames_s": "0.75", "memory_mb": "70", "reason": "n/a"})

    def test_page(self):
        rows = self.usable() + self.result(
            "sub-2", {"exit_code": 2, "reason": "<b>bad</b> & ugly"})
        measured = [group.read_run(Job(f"sub-{number}", "scene", "s.json"), self.out)[1]
                    for number in (1, 2)]
        text = page.as_html(rows, self.out, measured)
        self.assertIn("1 of 2 runs usable", text)
        self.assertIn("&lt;b&gt;bad&lt;/b&gt; &amp; ugly", text)
        self.assertIn('<a href="sub-1/scene/report.html">', text)
        self.assertNotIn("sub-2/scene/report.html", text)  # it has no page
        self.assertIn("moment arm of psoas_r about hip_flexion_r, mm/rad", text)
        self.assertIn("1 of 2 runs are compared. 1 has no usable frames: sub-2.", text)
        self.assertNotRegex(text, r'(?:src|href)="(?:https?:)?//|@import|url\(')
        balanced(self, text)

    def test_bins(self):
        self.assertEqual((1, 1, [3]), plots.counts([1, 1, 1]))
        low, high, bins = plots.counts([0.0, 0.5, 1.0, 1.0])
        self.assertEqual((0, 1, 4), (low, high, sum(bins)))
        self.assertEqual(2, bins[-1])
        self.assertIn("no figures", plots.histogram([None]))
        self.assertEqual(3, plots.histogram([1, None, 2, 4]).count("<rect"))


if __name__ == "__main__":
    unittest.main()
