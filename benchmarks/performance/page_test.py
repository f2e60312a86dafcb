# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The page: its generated chapters change, and nothing else does."""

import contextlib
import io
import pathlib
import tempfile
import unittest

import page
import recorded

CHAPTERS = ["Machine", "Stages", "Modes", "Growth", "Steps"]
COMMAND = "benchmarks/performance.sh DATA OUT"


def by_hand(name):
    return f"## By hand, before {name}\n\n"


def source_text():
    return "".join(
        by_hand(name) + "\n\nold\n\n".join(page.markers(name)) + "\n\n"
        for name in CHAPTERS
    )


class PageTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.figures = self.folder / "figures"
        self.figures.mkdir()
        recorded.write_figures(self.figures)
        self.page = self.folder / "page.md"
        self.page.write_text(source_text())

    def write(self):
        with contextlib.redirect_stdout(io.StringIO()) as said:
            page.write_page(self.figures, self.page, self.page, COMMAND)
        return said.getvalue()

    def chapter(self, name):
        begin, end = page.markers(name)
        return self.page.read_text().split(begin)[1].split(end)[0]

    def test_text_by_hand_stays(self):
        self.write()
        text = self.page.read_text()
        for name in CHAPTERS:
            self.assertIn(by_hand(name) + page.markers(name)[0], text)
            self.assertEqual(name == "Steps", "old" in self.chapter(name), name)

    def test_same_figures_give_the_same_page(self):
        self.write()
        first = self.page.read_text()
        self.write()
        self.assertEqual(first, self.page.read_text())

    def test_chapters_name_code_stages_and_plots_that_are_there(self):
        self.write()
        self.assertIn("`0.1.0 abc`", self.chapter("Machine").replace("\n", " "))
        for stage in recorded.STAGES:
            self.assertIn(f"| {stage} |", self.chapter("Stages"))
        for plot in ("growth_muscles.svg", "growth_vertices.svg"):
            self.assertIn(f"(page/{plot})", self.chapter("Growth"))
            self.assertTrue((self.folder / "page" / plot).exists())

    def test_steps_are_taken_if_they_are_there(self):
        self.assertIn("another build", self.write())
        (self.figures / "steps.md").write_text("| steps | 0.1.0 abc |\n")
        self.assertEqual("", self.write())
        self.assertIn("| steps |", self.chapter("Steps"))

    def test_busy_machine_is_told_on_the_page_and_on_the_screen(self):
        self.assertNotIn("busy", self.write() + self.chapter("Machine"))
        recorded.write_figures(self.figures, load=0.3)
        self.assertIn("busy", self.write())
        self.assertIn("took 30 %", self.chapter("Machine").replace("\n", " "))
        self.assertIn("**The machine was busy", self.chapter("Machine"))

    def expect_refused(self, *words):
        before = self.page.read_text()
        with self.assertRaises(ValueError) as caught:
            self.write()
        for word in words:
            self.assertIn(word, str(caught.exception))
        self.assertEqual(before, self.page.read_text())
        self.assertEqual({"figures", "page.md"}, {p.name for p in self.folder.iterdir()})

    def test_missing_figures_leave_the_page_alone(self):
        (self.figures / "solve_1.json").unlink()
        self.expect_refused("solve_")

    def test_missing_marker_leaves_the_page_alone(self):
        self.page.write_text(source_text().replace(page.markers("Growth")[1], ""))
        self.expect_refused("End of growth")

    def test_reports_of_two_builds_are_refused(self):
        other = recorded.report([recorded.frame(3)], code="0.1.0 def")
        recorded.write(self.figures, "mode_none_1_2", other)
        self.expect_refused("several builds")

    def test_page_of_the_repository_has_its_markers(self):
        text = (page.REPOSITORY / "docs/performance.md").read_text()
        for name in CHAPTERS:
            page.replaced(text, name, [])


if __name__ == "__main__":
    unittest.main()
