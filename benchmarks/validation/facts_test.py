# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""/usr/bin/python3 -m unittest discover -s benchmarks/validation -p '*_test.py'"""

import pathlib
import tempfile
import unittest

import facts

TABLE = """muscle,quantity,condition,value,unit,source,doi_or_pmcid
psoas,length,rest,3,mm,Somebody 1999 (how long),10.1/a (PMC1)
psoas,length,rest,2,mm,Somebody 1999 (how long),10.1/a (PMC1)
psoas,course,rest,,bends,Nobody,a book
"""


class FactsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        data = pathlib.Path(folder.name)
        (data / "literature").mkdir()
        (data / "literature/shape_facts.csv").write_text(TABLE)
        self.facts = facts.Facts(data)

    def test_values_ascend(self):
        rows = self.facts.find("psoas", "length", "rest", "mm")
        self.assertEqual(facts.values(rows), [2, 3])

    def test_what_is_not_there_is_named(self):
        with self.assertRaisesRegex(ValueError, "shape_facts.csv: no row .*MVC"):
            self.facts.find("psoas", "length", "MVC")

    def test_sources_are_short(self):
        rows = self.facts.find("psoas", "length", "rest")
        self.assertEqual(facts.source(rows[0]), "Somebody 1999, 10.1/a")
        (row,) = self.facts.find("psoas", "course", "rest")
        self.assertEqual(facts.source(row), "Nobody")

    def test_a_fact_without_a_value_is_a_trend(self):
        (row,) = self.facts.find("psoas", "course", "rest")
        line = facts.line_of(row, "", "straight", False)
        self.assertEqual(line[2:5], ["bends", "straight", "🔴 (trend)"])


if __name__ == "__main__":
    unittest.main()
