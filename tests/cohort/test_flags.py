#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The column "flags" is held against what musclewarp-deform says of itself."""
import os
import unittest

from folder import FolderTest
from musclewarp_cohort import flags
from musclewarp_cohort.input_error import InputError

KNOWN = {"data_root": False, "gap": False, "html": True, "resume": True}


class FlagsTest(FolderTest):

    def split(self, text):
        return flags.split(text, lambda *rest: "{}: {}; {}".format(*rest), "sub-1",
                           KNOWN)

    def expect_error(self, text, *lines):
        with self.assertRaises(InputError) as caught:
            self.split(text)
        self.assertEqual("\n".join(lines), str(caught.exception))

    def program(self, text):
        path = self.root / "program"
        path.write_text(text)
        os.chmod(path, 0o755)
        return path

    def test_flags_of_a_program(self):
        self.assertEqual(KNOWN, flags.of_program(self.deform))

    def test_other_programs(self):
        for text in ("#!/bin/sh\n", "#!/bin/sh\nexit 1\n", "no script",
                     '#!/bin/sh\necho "usage: musclewarp-check FILES"\n'
                     'echo "  --json"\n',
                     '#!/bin/sh\necho "usage: musclewarp-deform-all"\n'
                     'echo "  --json"\n'):
            with self.assertRaisesRegex(InputError, "name musclewarp-deform with"):
                flags.of_program(self.program(text))

    def test_a_wrapper_is_the_program_that_it_calls(self):
        wrapper = self.program('#!/bin/sh\necho "loading modules"\n'
                               f'exec "{self.deform}" "$@"\n')
        self.assertEqual(KNOWN, flags.of_program(wrapper))

    def test_flags_that_are_known(self):
        for text in ("--gap=0.2", "-gap 0.2", "--html", "--nohtml", "--html=false",
                     "--data-root=x", "--data_root 'a b' --gap=1"):
            self.split(text)

    def test_flags_that_are_not(self):
        self.expect_error("--gpa=0.2", "--gpa: of sub-1 is not a flag of "
                          "musclewarp-deform; write --gap, or another flag of "
                          "musclewarp-deform --help")
        self.expect_error("--xyz", "--xyz: of sub-1 is not a flag of "
                          "musclewarp-deform; allowed are --data_root, --gap, --html")
        self.expect_error("--nogap", "--nogap: of sub-1 is not a flag of "
                          "musclewarp-deform; write --gap, or another flag of "
                          "musclewarp-deform --help")

    def test_every_bad_flag_is_named(self):
        with self.assertRaises(InputError) as caught:
            self.split("--gpa=1 --gap=2 --data-rot=x --out=y --help")
        for line, word in zip(str(caught.exception).split("\n"),
                              ("--gpa:", "--data-rot:", "--out:", "--help:")):
            self.assertTrue(line.startswith(word), line)

    def test_values(self):
        self.assertEqual({"data_root": "b", "gap": "1", "html": "", "cache": ""},
                         flags.values(("--data_root=a", "--gap", "1", "--html",
                                       "--data-root=b", "--cache=", "x")))


if __name__ == "__main__":
    unittest.main()
