#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Adds a figure of a muscle to a copy of the sources by changing two files, and
looks for it wherever figures are shown.

  scripts/check_new_figure.py

The figure is a field with its line in the list of MuscleFigures, and one line
that measures it. After a build and scripts/generated.py it has to be in
report.json, in Python with its docstring, in the stub, in the types of the page
and in docs/report.md; a field without a line in the list must not compile.
Everything happens in the copy of the last commit that scripts/mutants.py has,
too (build/mutants); the first build there takes half an hour on two cores.

Exit code: 0 if it is everywhere, else 1.
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from commit_copy import COPY, builds, changed, check_out, configure_and_build

HEADER = "src/musclewarp/figures/muscle_figures.h"
SOURCE = "src/musclewarp/frames/frame_measures.cc"
TEXT = "largest coordinate of a vertex, whatever its sign"
TARGETS = ["musclewarp-deform", "musclewarp_python", "describe_figures",
           "describe_settings", "describe_joint_limits"]


def replaced(text, before, after):
    if text.count(before) != 1:
        sys.exit(f"check_new_figure: this should be there once:\n{before}")
    return text.replace(before, after)


def with_field(text):
    return replaced(text, "  double volume = 0;\n",
                    "  double volume = 0;\n  double farthest_coordinate = 0;\n")


def with_line_in_list(text):
    line = f"""      Field(&F::farthest_coordinate,
            "farthest_coordinate_mm",
            "mm")
          .Text("{TEXT}")
          .Later(),
"""
    return replaced(text, '      Field(&F::volume, "volume_mm3"',
                    line + '      Field(&F::volume, "volume_mm3"')


def measured(text):
    before = "  frame.volume_error ="
    return replaced(text, before, "  frame.farthest_coordinate = "
                    "fine.cwiseAbs().maxCoeff();\n" + before)


def said_by_python(out):
    """Returns the value of the figure and its docstring in Python."""
    code = f"""
import musclewarp as mw
scene = mw.read_scene({str(COPY / 'data/phantom/motion.json')!r})
muscle = mw.Deformer(scene).solve_alone(scene.poses[0]).muscles[0]
print(muscle.farthest_coordinate)
print(type(muscle).farthest_coordinate.__doc__)
print("farthest_coordinate" in type(muscle).__doc__)
"""
    environment = dict(os.environ, PYTHONPATH=str(COPY / "build/release/python"))
    return subprocess.run([sys.executable, "-c", code], env=environment, cwd=out,
                          check=True, capture_output=True,
                          text=True).stdout.split("\n")


def found(scratch):
    """Yields (place, whether the figure is there)."""
    out = scratch / "out"
    subprocess.run([COPY / "build/release/tools/musclewarp-deform",
                    f"--scene={COPY / 'data/phantom/motion.json'}",
                    "--frames=0", f"--out={out}"], check=True,
                   stdout=subprocess.DEVNULL)
    report = json.loads((out / "report.json").read_text(encoding="utf-8"))
    value = report["frames"][0]["muscles"][0].get("farthest_coordinate_mm")
    yield "report.json", bool(value) and value > 10
    lines = said_by_python(scratch)
    yield "Python", float(lines[0]) > 10
    yield "its docstrings", lines[1] == TEXT and lines[2] == "True"
    subprocess.run([COPY / "scripts/generated.py"], check=True)
    for file, text in (
            ("python/musclewarp/_core.pyi", "def farthest_coordinate(self) -> float"),
            ("tools/report/src/data/figures.ts", "farthest_coordinate_mm?: number;"),
            ("docs/report.md", f"| `farthest_coordinate_mm` | mm | "
                               f"{TEXT[0].upper() + TEXT[1:]} |")):
        yield file, text in (COPY / file).read_text(encoding="utf-8")


def main():
    check_out()
    configure_and_build("release", TARGETS)
    with changed(HEADER, with_field):
        places = [("no build without a line in the list",
                   not builds(["musclewarp-deform"]))]
    scratch = pathlib.Path(tempfile.mkdtemp(prefix="check_new_figure_"))
    try:
        with changed(HEADER, lambda text: with_line_in_list(with_field(text))), \
                changed(SOURCE, measured):
            if not builds(TARGETS):
                sys.exit("check_new_figure: the figure does not compile")
            places += found(scratch)
    finally:
        shutil.rmtree(scratch)
        check_out()
    for place, is_there in places:
        print(f"{'found ' if is_there else 'MISSING'} {place}", flush=True)
    return 0 if all(is_there for _, is_there in places) else 1


if __name__ == "__main__":
    sys.exit(main())
