#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""benchmarks/performance.sh measures and writes its page, or says what is missing."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
RECORDED = SOURCE / "benchmarks/performance"

# Programs that only play the real ones: each writes what it is asked for. The sizes
# of files are those of meshes.
FAKE = f"""\
#!{sys.executable} -B
import json, pathlib, sys
sys.path.insert(0, {str(RECORDED)!r})
import numpy, recorded, refined_scene
given = dict(word.lstrip("-").partition("=")[::2] for word in sys.argv[1:])
"""
DEFORM = """\
out, scene = pathlib.Path(given["out"]), pathlib.Path(given["scene"])
meshes = [scene.parent / part["mesh"] for part in json.loads(scene.read_text())["muscles"]]
sizes = [mesh.stat().st_size for mesh in meshes if mesh.exists()] or [100]
frames = [recorded.frame(index, ms=sum(sizes)) for index in range(5)]
out.mkdir()
recorded.write(out, "report", recorded.report(frames, sizes))
"""
PHANTOM = """\
out = pathlib.Path(given["out"])
out.mkdir()
names = [f"{k}.ply" for k in range(int(given["num_muscles"]))]
for name in names:
    refined_scene.write_ply(out / name, numpy.eye(3), numpy.array([[0, 1, 2]]))
scene = {"muscles": [{"mesh": name} for name in names], "bones": []}
recorded.write(out, "scene", scene)
"""
SOLVE = """\
out = pathlib.Path(given["benchmark_out"])
recorded.write(out.parent, out.stem, recorded.solve(5))
"""
FAKES = {
    "tools/musclewarp-deform": DEFORM,
    "tools/musclewarp-phantom": PHANTOM,
    "benchmarks/solve_benchmark": SOLVE,
}


class CommandTest(unittest.TestCase):

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.data, self.out = self.folder / "data", self.folder / "out"
        (self.data / "lhdl_hip").mkdir(parents=True)
        self.build = self.folder / "build"
        for name, text in FAKES.items():
            self.program(name, FAKE + text)

    def program(self, name, text):
        path = self.build / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        path.chmod(0o755)

    def run_script(self, *words):
        return subprocess.run(
            [SOURCE / "benchmarks/performance.sh", *words],
            capture_output=True, text=True)

    def quick(self):
        return self.run_script(
            self.data, self.out, "--quick", f"--programs={self.build}")

    def expect_refused(self, done, *words):
        self.assertEqual(2, done.returncode, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(self.out.exists())

    def test_measures_everything_and_writes_a_page_of_its_own(self):
        page = (SOURCE / "docs/performance.md").read_bytes()
        done = self.quick()
        self.assertEqual(0, done.returncode, done.stderr)
        self.assertIn("Abacus", (self.out / "performance.md").read_text())
        self.assertTrue((self.out / "performance/growth_vertices.svg").exists())
        self.assertEqual(
            {"figures", "performance", "performance.md"},
            {path.name for path in self.out.iterdir()})
        self.assertEqual(page, (SOURCE / "docs/performance.md").read_bytes())

    def test_missing_words_show_the_usage(self):
        self.expect_refused(self.run_script(self.data), "usage:", "--quick")
        self.expect_refused(self.run_script("--fast"), "usage:")

    def test_missing_data_are_named(self):
        (self.data / "lhdl_hip").rmdir()
        self.expect_refused(self.quick(), str(self.data), "lhdl_hip")

    def test_missing_program_is_named(self):
        (self.build / "benchmarks/solve_benchmark").unlink()
        self.expect_refused(self.quick(), "solve_benchmark")

    def test_missing_build_folder_is_named(self):
        self.build = self.folder / "nowhere"
        self.expect_refused(self.quick(), "nowhere")

    def test_failure_of_a_program_leaves_no_page(self):
        self.program(
            "tools/musclewarp-deform", "#!/bin/sh\necho no such scene >&2\nexit 2\n")
        done = self.quick()
        self.assertEqual(1, done.returncode)
        self.assertIn("no such scene", done.stderr)
        self.assertIn("musclewarp-deform", done.stderr)
        self.assertFalse((self.out / "performance.md").exists())
        self.assertFalse((self.out / "work").exists())


if __name__ == "__main__":
    try:
        import numpy  # noqa: F401
    except ImportError as error:
        print(f"skipped: {error}; apt-get install python3-numpy")
        sys.exit(77)
    unittest.main()
