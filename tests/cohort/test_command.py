#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""musclewarp-cohort: what it refuses, and runs from end to end where Snakemake is
installed: with a musclewarp-deform that is played, and with the real one."""
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import unittest

from folder import COLUMNS, COMMAND, SOURCE, FolderTest, frame, report
from musclewarp_cohort import VERSION, files

PROGRAMS = pathlib.Path(os.environ.get("MUSCLEWARP_PROGRAMS",
                                       SOURCE / "build/release/tools"))
needs_snakemake = unittest.skipUnless(
    shutil.which("snakemake"), "snakemake is not installed (apt install snakemake)")
USABLE = report([frame(0, [("psoas", 1.0, {})])])


class CommandTest(FolderTest):

    def cohort(self, *words, path=None):
        environment = {**os.environ, "PATH": path or os.environ["PATH"]}
        return subprocess.run(
            [sys.executable, "-B", COMMAND, *map(str, words)], env=environment,
            capture_output=True, text=True, timeout=100, check=False)

    def group(self, *words, deform=None):
        return self.cohort(self.source, self.out, "group", "--cores", "1",
                           "--deform", deform or self.deform, *words)

    def expect_refusal(self, done, *words):
        self.assertEqual(2, done.returncode, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(self.out.exists())

    def scene(self, name, **how):
        self.file(f"{name}.json", json.dumps(how))
        return f"{name} {name}.json - - - -"

    def runs(self, name):
        return (self.out / name / "scene/runs.txt").read_text().splitlines()

    def rows(self):
        header, *lines = (self.out / "group.tsv").read_text().splitlines()
        return [dict(zip(header.split("\t"), line.split("\t"))) for line in lines]


class RefusalTest(CommandTest):

    def test_what_is_refused(self):
        self.expect_refusal(self.group(), "subjects.tsv: does not exist")
        self.table("sub-1 a.json", columns=("participant_id", "scene"))
        self.expect_refusal(self.group(), "line 1: has no column model, motion")
        self.table("sub-1 no.json - - - -")
        self.expect_refusal(self.group(), 'line 2, scene: "no.json" is not a file')
        self.table(self.scene("sub-1"))
        self.expect_refusal(self.group("--participant-label", "2"), '"2" is not in')
        self.expect_refusal(self.group("--profile", "pbs"), '"pbs" is neither one of '
                            "local, slurm nor a folder")
        self.expect_refusal(self.group(deform=self.root / "none"), "--deform:")
        self.expect_refusal(self.group(deform="/bin/true"), '--deform: "/bin/true" '
                            "is not musclewarp-deform")
        self.expect_refusal(self.group("--cores", "0"), "--cores is 0; 1 or more")
        self.expect_refusal(self.cohort(self.source, self.out, "all"), "participant")
        self.expect_refusal(self.cohort(self.root / "x", self.out, "group"),
                            "x: is not a folder")

    @unittest.skipIf(shutil.which("musclewarp-export"), "it is installed")
    def test_divided_runs_need_musclewarp_export(self):
        self.table(self.scene("sub-1") + " 3", columns=(*COLUMNS, "parts"))
        self.expect_refusal(self.group(), "musclewarp-export: is neither in "
                            f"{self.root}", "it fits the functions of divided runs")

    def test_unknown_flags_are_found_before_any_job_starts(self):
        self.scene("sub-1")
        self.table("sub-1 sub-1.json - - - --gap=0.2",
                   "sub-2 sub-1.json - - - --gpa=0.2")
        self.expect_refusal(self.group(), 'subjects.tsv, line 3, flags: "--gpa" of '
                            "sub-2 is not a flag of musclewarp-deform; write --gap")

    def test_snakemake_is_not_installed(self):
        self.table(self.scene("sub-1"))
        done = self.cohort(self.source, self.out, "group", "--deform", self.deform,
                           path=str(self.root))
        self.expect_refusal(done, "snakemake: is not in a folder of PATH; install it")

    def test_version_is_that_of_the_project(self):
        project = (SOURCE / "CMakeLists.txt").read_text()
        self.assertEqual(re.search(r"project\(musclewarp VERSION (\S+)", project)[1],
                         VERSION)
        self.assertIn(VERSION, self.cohort("--version").stdout)

    def test_help_names_every_flag(self):
        said = self.cohort("--help").stdout
        for flag in re.findall(r'add_argument\("(--[\w-]+)"', COMMAND.read_text()):
            if flag not in ("--help", "--version"):
                self.assertRegex(said, rf"(?m)^  {flag}(=|$)")


@needs_snakemake
class RunTest(CommandTest):

    def test_failures_do_not_stop_the_others(self):
        self.table(
            self.scene("good", report=USABLE),
            self.scene("bad", exit=2, says="musclewarp-deform: a.ply: is no mesh"),
            self.scene("dead", signal=signal.SIGKILL))
        done = self.group()
        self.assertEqual(1, done.returncode, done.stderr)
        self.assertIn("bad scene: refused: a.ply: is no mesh\n", done.stdout)
        self.assertIn("dead scene: not finished: killed by SIGKILL", done.stdout)
        self.assertIn("3 jobs in", done.stdout)
        self.assertIn("3 of 3 jobs to do", done.stdout)
        for place in (1, 2, 3):
            self.assertEqual(1, done.stdout.count(f"\n[{place} of 3] "), done.stdout)
        for name in ("bad", "dead"):
            self.assertIn(f"; see {self.out}/{name}/scene/job.log\n", done.stdout)
        # Snakemake speaks in its log alone, which is named where it fails.
        log = self.out / "snakemake.log"
        self.assertIn(f"exit code 1; what it said is in {log}\n", done.stdout)
        said = log.read_text()
        for word in ("Building DAG", "Error in rule deform", "rule group"):
            self.assertIn(word, said)
            self.assertNotIn(word, done.stdout + done.stderr)
        self.assertEqual(["usable", "refused", "not finished"],
                         [row["status"] for row in self.rows()])
        self.assertIn("1 of 3 runs usable", (self.out / "group.html").read_text())

        # What ended is not done again; what was killed is.
        self.scene("dead", report=USABLE)
        self.assertEqual(1, self.group().returncode)
        self.assertEqual([1, 1], [len(self.runs(name)) for name in ("good", "bad")])
        self.assertEqual("usable", self.rows()[2]["status"])

        # What is mended is done.
        self.scene("bad", report=USABLE)
        done = self.group()
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertEqual(1, len(self.runs("good")))

    def test_exit_code_0_without_a_report_is_a_failure(self):
        self.table(self.scene("good", report=USABLE), self.scene("none"),
                   self.scene("odd", report={"summary": {"finished": True}}))
        done = self.group()
        self.assertEqual(1, done.returncode, done.stderr)
        self.assertIn("none scene: not finished: musclewarp-deform ended with exit "
                      "code 0, but it wrote no report.json", done.stdout)
        self.assertIn("odd scene: not finished: musclewarp-deform ended with exit "
                      "code 0, but report.json does not say", done.stdout)
        self.assertEqual(["usable", "not finished", "not finished"],
                         [row["status"] for row in self.rows()])

    @unittest.skipUnless((PROGRAMS / "musclewarp-export").exists(),
                         "musclewarp-export is not built")
    def test_a_design_is_divided_and_its_functions_are_gathered(self):
        """They are those of the run that is not divided, also if a part was killed
        on the way."""
        subprocess.run([PROGRAMS / "musclewarp-phantom", "--scene=hip", "--seed=1",
                        f"--out={self.source}"], check=True, stdout=subprocess.DEVNULL)
        scene = json.loads((self.source / "motion.json").read_text())
        scene["muscles"] = [muscle for muscle in scene["muscles"]
                            if muscle["name"] == "gluteus_minimus_r"]
        scene["motion"] = {"design": "latin_hypercube", "postures": 15,
                           "coordinates": {"hip_flexion_r": [-10, 40]}}
        self.file("design.json", json.dumps(scene))
        self.table("sub-1 design.json - - - --nohtml 2",
                   "sub-2 design.json - - - --nohtml 1",
                   columns=(*COLUMNS, "parts"))
        deform = PROGRAMS / "musclewarp-deform"
        done = self.group(deform=deform)
        self.assertEqual(0, done.returncode, done.stdout + done.stderr)
        self.assertIn("sub-1 scene part 2 of 2: usable", done.stdout)
        self.assertIn("3 jobs in", done.stdout)
        self.assertEqual([("usable", "15")], list({
            (row["status"], row["frames"]) for row in self.rows()}))
        divided, whole = (self.coefficients(name) for name in ("sub-1", "sub-2"))
        self.assertEqual(divided, whole)

        shutil.rmtree(self.out / "sub-1/scene/part_0002")
        done = self.group(deform=deform)
        self.assertEqual(0, done.returncode, done.stdout + done.stderr)
        self.assertIn("1 of 3 jobs to do", done.stdout)
        self.assertEqual(whole, self.coefficients("sub-1"))

        (self.source / "hip.osim").unlink()
        done = self.group(deform=deform)
        self.assertEqual(1, done.returncode)
        self.assertIn("sub-1 scene: no functions; see", done.stdout)

    def coefficients(self, name):
        fit = json.loads((self.out / name / "scene/fit.json").read_text())
        return {path: function["coefficients_mm"]
                for path, function in fit["muscles"].items()}

    def test_a_failure_of_snakemake_itself_is_told(self):
        self.table(self.scene("sub-1", report=USABLE))
        profile = self.root / "profile"
        profile.mkdir()
        (profile / "config.yaml").write_text("no-such-setting: 1\n")
        done = self.group("--profile", profile)
        self.assertEqual(1, done.returncode)
        self.assertIn(f"what it said is in {self.out}/snakemake.log", done.stdout)
        self.assertIn("no-such-setting", done.stdout)

    def test_levels_and_labels(self):
        self.table(*(self.scene(f"sub-{i}", report=USABLE) for i in (1, 2)))
        done = self.cohort(self.source, self.out, "participant", "--deform",
                           self.deform, "--participant-label", "2")
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertFalse((self.out / "sub-1").exists())
        self.assertFalse((self.out / "group.tsv").exists())
        self.assertEqual(0, self.group().returncode)
        self.assertEqual(1, len(self.runs("sub-2")))
        self.assertEqual(["sub-1", "sub-2"],
                         [row["participant_id"] for row in self.rows()])

    def test_frames_may_be_removed(self):
        self.table(self.scene("sub-1", report=USABLE))
        self.assertEqual(0, self.group().returncode)
        (self.out / "sub-1/scene/runs.txt").rename(self.root / "runs.txt")
        self.assertEqual(0, self.group().returncode)
        self.assertFalse((self.out / "sub-1/scene/runs.txt").exists())

    def test_one_at_a_time(self):
        self.table(self.scene("sub-1", report=USABLE))
        self.out.mkdir()
        with files.locked(self.out / ".cohort.lock", wait=False):
            done = self.group()
        self.assertEqual(2, done.returncode)
        self.assertIn("another musclewarp-cohort", done.stderr)
        self.assertEqual([".cohort.lock"], os.listdir(self.out))

    def test_dry_run(self):
        self.table(self.scene("sub-1", report=USABLE))
        done = self.group("--dry-run")
        self.assertEqual(0, done.returncode)
        self.assertIn("would run sub-1 scene", done.stdout)
        self.assertFalse((self.out / "sub-1").exists())

    @unittest.skipUnless((PROGRAMS / "musclewarp-deform").exists(),
                         "musclewarp-deform is not built")
    def test_real_subjects(self):
        for name in ("sub-1", "sub-2"):
            subprocess.run([PROGRAMS / "musclewarp-phantom", "--scene=random",
                            "--num_muscles=2", "--seed=1",
                            f"--out={self.source / name}"],
                           check=True, stdout=subprocess.DEVNULL)
        self.file("sub-2/muscle_01.ply", "ply\nno mesh\n")
        self.table("sub-1 sub-1/scene.json - - left --frames=0:1",
                   "sub-2 sub-2/scene.json - - - -")
        done = self.group(deform=PROGRAMS / "musclewarp-deform")
        self.assertEqual(1, done.returncode, done.stderr)
        self.assertIn("sub-2 scene: refused: ", done.stdout)
        self.assertIn("muscle_01.ply: is truncated", done.stdout)
        one, two, refused = self.rows()
        for row in (one, two):
            self.assertEqual(("usable", "2", "2", "0"), tuple(row[name] for name in (
                "status", "frames", "usable_frames", "crossings")))
            self.assertLessEqual(float(row["max_volume_error"]), 1e-8)
            self.assertGreaterEqual(float(row["least_gap_mm"]), 0.1)
        self.assertEqual("2", refused["exit_code"])
        said = json.loads((self.out / "sub-1/scene/report.json").read_text())
        self.assertEqual("left", said["side"])

        # A job that was killed after its last frame finds its report finished.
        made = self.out / "sub-1/scene/report.json"
        written = made.stat().st_mtime_ns
        (self.out / "sub-1/scene/job.json").unlink()
        self.group(deform=PROGRAMS / "musclewarp-deform")
        self.assertEqual("usable", self.rows()[0]["status"])
        self.assertEqual(written, made.stat().st_mtime_ns)


if __name__ == "__main__":
    unittest.main()
