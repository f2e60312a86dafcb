#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""subjects.tsv becomes jobs, or a message that says what to mend."""
import json
import unittest

from folder import COLUMNS, FolderTest
from musclewarp_cohort import flags, table
from musclewarp_cohort.input_error import InputError


class TableTest(FolderTest):

    def setUp(self):
        super().setUp()
        for name in ("a.json", "b.json", "m.osim", "walk.mot"):
            self.file(name)

    def expect_error(self, *words, known_flags=None):
        with self.assertRaises(InputError) as caught:
            table.read_jobs(self.source, known_flags)
        for word in words:
            self.assertIn(word, str(caught.exception))

    def test_rows_become_jobs(self):
        self.table("sub-1 a.json m.osim walk.mot left -",
                   "sub-1 a.json - - - --gap=0.2",
                   "sub-2 b.json - - - -")
        first, second, third = table.read_jobs(self.source)
        self.assertEqual("sub-1/walk", first.folder)
        self.assertEqual(str(self.source / "m.osim"), first.model)
        self.assertEqual(str(self.source / "walk.mot"), first.motion_file)
        self.assertEqual("left", first.side)
        self.assertEqual("sub-1/scene", second.folder)
        self.assertEqual(("--gap=0.2",), second.flags)
        self.assertIsNone(second.model or second.motion_file or second.side)
        self.assertEqual((), third.flags)

    def test_empty_fields_and_other_columns(self):
        self.file("subjects.tsv", "\ufeffage\tparticipant_id\tscene\tmodel\t"
                  "motion\tside\tflags\r\n30\tP_1\ta.json\t\t\t\t\r\n\r\n")
        job, = table.read_jobs(self.source)
        self.assertEqual(("P_1", "scene", ()), (job.participant, job.motion, job.flags))

    def test_runs_are_divided(self):
        columns = (*COLUMNS, "parts")
        self.table("s-1 a.json - - - - 3", "s-2 a.json - - - - -", columns=columns)
        divided, whole = table.read_jobs(self.source)
        self.assertEqual(["s-1/scene/part_0001", "s-1/scene/part_0002",
                          "s-1/scene/part_0003"],
                         [part.folder for part in divided.divided()])
        self.assertEqual("s-1 scene part 2 of 3", divided.divided()[1].title)
        self.assertEqual([whole], whole.divided())
        for parts in ("0", "-1", "2.5", "many", "10000"):
            self.table(f"s a.json - - - - {parts}", columns=columns)
            self.expect_error(f'line 2, parts: "{parts}" is not a number of parts')
        self.table("s a.json - - - --frames=0:9 3", columns=columns)
        self.expect_error('line 2, flags: "--frames=0:9" has frames, as the column')

    def test_missing_column(self):
        self.table("sub-1 a.json", columns=("participant_id", "scene"))
        self.expect_error("subjects.tsv, line 1", "model, motion, side, flags", "n/a")

    def test_no_table(self):
        self.expect_error("subjects.tsv: does not exist", "participant_id")

    def test_no_rows(self):
        self.table()
        self.expect_error("has no subjects")

    def test_row_of_another_length(self):
        self.table("sub-1 a.json - - -")
        self.expect_error("line 2: has 5 fields, and the header 6", "tab")

    def test_every_bad_row_is_named(self):
        self.table("sub-1 no.json - - - -", "sub-2 a.json - no.mot - -",
                   "../x a.json - - up -",
                   "sub-4 - - - - n/a")
        self.expect_error('line 2, scene: "no.json" is not a file of',
                          'line 3, motion: "no.mot" is not a file of',
                          'line 4, participant_id: "../x" cannot name a folder',
                          'line 4, side: "up" is not a side; write left, right',
                          'line 5, scene: "n/a" may not be here')

    def test_messages_end(self):
        self.table(*(f"sub{i} no.json - - - -" for i in range(30)))
        self.expect_error("line 21,", "10 more of the kind")

    def test_same_subject_and_motion_twice(self):
        self.table("s a.json - - - -", "s b.json - - - -")
        self.expect_error('line 3, participant_id: "s" has the motion "scene" in '
                          "line 2, too")

    def test_flags_that_are_taken(self):
        for flag, advice in (("--out=x", "OUT is given"),
                             ("-scene=x", 'the column "scene"'),
                             ("--noresume", "always on"),
                             ("--threads=3", "--set-threads"),
                             ("gap=1", "is not a flag"),

                             ('"--gap', "quotation")):
            self.table(f"s a.json - - - {flag}")
            self.expect_error("line 2, flags", advice,
                              known_flags={"gap": False, "html": True})

    def test_words_among_flags_that_are_none(self):
        known = {"gap": False, "html": True}

        def where(value, allowed, advice):
            return f'"{value}" {allowed}; {advice}'

        self.assertEqual(flags.split("--gap 1 --html --nohtml", where, "s", known),
                         ("--gap", "1", "--html", "--nohtml"))
        for text, word in (("--gap 1 html", "html"), ("--html 1", "1"), ("--nohtml 1", "1")):
            with self.assertRaises(InputError) as caught:
                flags.split(text, where, "s", known)
            self.assertIn(f'"{word}" is not a flag of musclewarp-deform', str(caught.exception))

    def test_names_of_folders_are_not_too_long(self):
        self.table("s" * 100 + " a.json - - - -")
        self.assertEqual(len(table.read_jobs(self.source)), 1)
        self.table("s" * 101 + " a.json - - - -")
        self.expect_error("line 2, participant_id", "has 101 characters", "allowed are 100")

    def test_flags_that_are_not_there(self):
        self.table("sub-1 a.json - - - --gap=0.2", "sub-2 a.json - - - --gpa=0.2",
                   "sub-3 a.json - - up --xyz")
        self.expect_error('subjects.tsv, line 3, flags: "--gpa" of sub-2 is not a '
                          "flag of musclewarp-deform; write --gap",
                          'line 4, flags: "--xyz" of sub-3', 'line 4, side: "up"',
                          known_flags={"gap": False})

    def test_labels(self):
        self.table(*(f"sub-{i} a.json - - - -" for i in (1, 2, 10)))
        jobs = table.read_jobs(self.source)
        chosen = table.choose(jobs, ["10", "sub-1"])
        self.assertEqual(["sub-1", "sub-10"], [job.participant for job in chosen])
        with self.assertRaisesRegex(InputError, '"sub-3" is not in subjects.tsv; '
                                    "there are 3, such as sub-"):
            table.choose(jobs, ["sub-3"])

    def test_folders_among_flags_are_relative_to_the_table(self):
        for given, flags in (("--cache=kept", f"--cache={self.source / 'kept'}"),
                             ("--data-root=x", f"--data_root={self.source / 'x'}"),
                             ("--cache=none", "--cache=none")):
            self.table(f"s a.json - - - {given}")
            job, = table.read_jobs(self.source)
            self.assertEqual(flags, job.flags[-1])

    def test_files_that_a_job_reads(self):
        self.file("data/psoas.ply")
        self.file("data/femur.ply")
        self.file("s.json", json.dumps({
            "muscles": [{"mesh": "psoas.ply"}, {"mesh": "none.ply"}],
            "bones": [{"mesh": "femur.ply"}, {"name": "no mesh"}],
            "motion": "walk.mot"}))
        self.table("s s.json m.osim walk.mot - --data_root=data")
        job, = table.read_jobs(self.source)
        self.assertEqual(str(self.source / "data"), job.data_root())
        names = [file[len(str(self.source)) + 1:] for file in table.input_files(job)]
        self.assertEqual(["s.json", "m.osim", "walk.mot", "data/psoas.ply",
                          "data/femur.ply"], names)

    def test_a_motion_in_the_scene_is_no_file_of_its_own(self):
        self.file("leg.osim")
        self.file("psoas.ply")
        self.file("s.json", json.dumps({
            "muscles": [{"mesh": "psoas.ply"}], "model": "leg.osim",
            "motion": {"frames": 2, "coordinates": {"knee": [0, 9]}}}))
        self.table("s s.json - - - -")
        job, = table.read_jobs(self.source)
        self.assertEqual([str(self.source / name)
                          for name in ("s.json", "psoas.ply", "leg.osim")],
                         table.input_files(job))

    def test_bones_of_the_model_and_objects_of_files_are_inputs(self):
        names = ("leg.osim", "psoas.obj", "Geometry/femur.vtp", "more/pelvis.stl")
        for name in names:
            self.file(name)
        self.file("leg.osim", "<Mesh><mesh_file> femur.vtp </mesh_file></Mesh>"
                  "<geometry_file>pelvis.stl</geometry_file>"
                  "<mesh_file>none.stl</mesh_file>")
        self.file("s.json", json.dumps({
            "muscles": [{"mesh": "psoas.obj#left"}], "bones": "model",
            "model": "leg.osim", "geometry": "more"}))
        self.table("s s.json - - - -")
        job, = table.read_jobs(self.source)
        self.assertEqual({str(self.source / name) for name in ("s.json", *names)},
                         set(table.input_files(job)))

    def test_a_scene_that_cannot_be_read_is_an_input(self):
        for text in ("{", "[1]", '{"muscles": 3}', '{"muscles": [{"mesh": 1}]}'):
            self.file("a.json", text)
            self.table("s a.json - - - -")
            job, = table.read_jobs(self.source)
            self.assertEqual([str(self.source / "a.json")], table.input_files(job))


if __name__ == "__main__":
    unittest.main()
