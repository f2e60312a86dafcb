# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""A folder with subjects, and a musclewarp-deform that only plays one."""
import html.parser
import os
import pathlib
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "cohort"))
COMMAND = SOURCE / "cohort/musclewarp-cohort"
COLUMNS = ("participant_id", "scene", "model", "motion", "side", "flags")

HELP = """\
usage: musclewarp-deform --scene=FILE --out=DIR [flags]

Flags (--flagfile=F reads them from a file):
  --data_root=TEXT
      folder
  --gap=NUMBER
      distance [0.1]
  --html
      a page [false]
  --resume
      go on [false]
"""
# Its scene says, as JSON, how it ends: "exit", "says", "report", "signal"; it
# counts its runs in OUT/runs.txt, and --resume has to be there.
FAKE = f"""\
#!{sys.executable}
import json, os, pathlib, sys
if sys.argv[1:] == ["--help"]:
    sys.exit(print({HELP!r}))
""" + """\
if sys.argv[1:] == ["--version"]:
    sys.exit(print("musclewarp-deform 0"))
flags = dict(word[2:].partition("=")[::2] for word in sys.argv[1:])
assert "resume" in flags
out = pathlib.Path(flags["out"])
with open(out / "runs.txt", "a") as file:
    print(*sys.argv[1:], file=file)
play = json.loads(pathlib.Path(flags["scene"]).read_text())
print(play.get("says", "deforming"), flush=True)
if "report" in play:
    (out / "report.json").write_text(json.dumps(play["report"]))
if "signal" in play:
    os.kill(os.getpid(), play["signal"])
sys.exit(play.get("exit", 0))
"""


def frame(index, muscles, usable=True, **more):
    """A frame of report.json; `muscles` are (name, volume ratio, arms)."""
    return {"index": index, "name": f"step_{index}", "usable": usable,
            "wall_ms": 250.0, "stop_reason": "converged", "shortcomings": [],
            "muscles": [{"name": name, "volume_ratio": ratio, "self_pairs": 0,
                         "line_moment_arms_mm": arms}
                        for name, ratio, arms in muscles],
            "intersections": {"pairs": []}, "gaps": [], **more}


def report(frames, finished=True, stopped=None):
    names = [muscle["name"] for muscle in frames[0]["muscles"]] if frames else []
    return {"prepare": {"wall_ms": 1500.0, "contact_ms": 500.0,
                        "muscles": [{"name": name} for name in names]},
            "frames": frames,
            "summary": {"finished": finished, "stopped": stopped,
                        "usable": bool(frames) and all(
                            frame["usable"] for frame in frames)}}


class FolderTest(unittest.TestCase):
    """Works in a folder of its own, with IN and OUT below it."""

    def setUp(self):
        self._kept = tempfile.TemporaryDirectory(prefix="musclewarp cohort ")
        self.addCleanup(self._kept.cleanup)
        self.root = pathlib.Path(self._kept.name)
        self.source, self.out = self.root / "in", self.root / "out"
        self.source.mkdir()
        self.deform = self.root / "musclewarp-deform"
        self.deform.write_text(FAKE)
        os.chmod(self.deform, 0o755)

    def file(self, name, text="{}"):
        path = self.source / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def table(self, *rows, columns=COLUMNS):
        """Rows are texts with fields between blanks, - for n/a."""
        lines = [["n/a" if field == "-" else field for field in row.split()]
                 for row in rows]
        text = "\n".join("\t".join(line) for line in [columns, *lines])
        return self.file("subjects.tsv", text + "\n")


class _Balanced(html.parser.HTMLParser):
    """Fails where a tag is not closed in its order."""

    ALONE = {"meta", "line", "rect"}

    def __init__(self, test):
        super().__init__()
        self._test, self._open = test, []

    def handle_starttag(self, tag, attributes):
        if tag not in self.ALONE:
            self._open.append(tag)

    def handle_startendtag(self, tag, attributes):
        pass

    def handle_endtag(self, tag):
        if tag not in self.ALONE:
            self._test.assertEqual(self._open.pop(), tag)

    def expect_end(self):
        self._test.assertEqual([], self._open)


def balanced(test, text):
    """Fails where a tag of HTML is not closed in its order."""
    parser = _Balanced(test)
    parser.feed(text)
    parser.close()
    parser.expect_end()
