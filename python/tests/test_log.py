# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Lines of the log of the library."""
import logging
import subprocess
import sys

import musclewarp as mw
from conftest import muscle, quick, spindle


def far_scene():
    """A bone in other units, which is warned of."""
    points, triangles = spindle(45)
    return mw.Scene([muscle("psoas", 0)],
                    [mw.Bone("femur", points * 1000, triangles)])


def test_warnings_go_to_logging(caplog):
    with caplog.at_level(logging.INFO, logger="musclewarp"):
        deformer = quick(far_scene(), contact="none")
    assert len(deformer.warnings) == 1
    assert [(r.name, r.levelno, r.getMessage()) for r in caplog.records] == [
        ("musclewarp", logging.WARNING, deformer.warnings[0])]


def test_nothing_else_is_printed():
    script = ("import sys, logging; sys.path.insert(0, sys.argv[1])\n"
              "from test_log import *\n"
              "logging.getLogger('musclewarp').addHandler("
              "logging.NullHandler())\n"
              "quick(far_scene(), contact='none')")
    said = subprocess.run([sys.executable, "-c", script, *sys.path[:1]],
                          capture_output=True, text=True, check=True)
    assert (said.stdout, said.stderr) == ("", "")
