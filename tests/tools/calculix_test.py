#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""CalculiX computes a step of gravity with what musclewarp-export writes of the embedded
scene, bones and contact pairs included, by the deck of docs/export.md.

usage: MUSCLEWARP_DEFORM=... MUSCLEWARP_EXPORT=... MUSCLEWARP_SOURCE=... calculix_test.py

Exits with 77 if CalculiX or tetgen is not there.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SKIPPED = 77
for program, package in (("ccx", "calculix-ccx"), ("tetgen", "tetgen")):
    if shutil.which(program) is None:
        print(f"skipped: there is no {program}; apt-get install {package}")
        sys.exit(SKIPPED)
SOURCE = pathlib.Path(os.environ["MUSCLEWARP_SOURCE"])


def deck_of_docs():
    text = (SOURCE / "docs/export.md").read_text(encoding="utf-8")
    lines = re.search(r"(?:^    .*\n)*^    \*INCLUDE.*\n(?:^    .*\n)*", text, re.M).group()
    return re.sub("^    ", "", lines, flags=re.M)


class Calculix(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="musclewarp_calculix_")
        cls.folder = pathlib.Path(cls.temporary.name)
        scene = SOURCE / "data/phantom/motion.json"
        subprocess.run(
            [os.environ["MUSCLEWARP_DEFORM"], f"--scene={scene}", f"--out={cls.folder}/run",
             "--frames=0"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(
            [os.environ["MUSCLEWARP_EXPORT"], f"--in={cls.folder}/run",
             f"--out={cls.folder}/elements", "--format=inp"],
            check=True, stdout=subprocess.DEVNULL)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def displacements(self, name, deck):
        """The displacements of the nodes of muscles, mm."""
        deck = deck.replace("*NODE FILE", "*NODE PRINT, NSET=MUSCLE_NODES")
        (self.folder / f"{name}.inp").write_text(deck, encoding="utf-8")
        output = subprocess.run(["ccx", "-i", name], cwd=self.folder, capture_output=True,
                                text=True, check=True).stdout
        self.assertIn("Job finished", output)
        self.assertNotIn("*ERROR", output)
        numbers = [line.split() for line in (self.folder / f"{name}.dat").read_text().splitlines()
                   if re.match(r"\s+\d+\s", line)]
        return {int(row[0]): [float(x) for x in row[1:]] for row in numbers}

    def test_muscles_sag_and_stay_attached(self):
        moved = self.displacements("gravity", deck_of_docs())
        farthest = max(abs(x) for row in moved.values() for x in row)
        # 1.1 mm. Without contact they sag by more than 4 mm.
        self.assertGreater(farthest, 0.2)
        self.assertLess(farthest, 3)

    def test_nothing_moves_without_a_load(self):
        """No gap is taken for a contact."""
        deck = deck_of_docs().replace("9810.", "0.")
        moved = self.displacements("at_rest", deck)
        self.assertGreater(len(moved), 10000)
        self.assertEqual(max(abs(x) for row in moved.values() for x in row), 0)


if __name__ == "__main__":
    unittest.main()
