# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C, and what happens when Python ends."""
import os
import pathlib
import signal
import subprocess
import sys
import time

import pytest

from conftest import DEMO

TESTS = pathlib.Path(__file__).parent

# Ctrl-C stops within a second. Here it comes a moment after the computation
# began, and processes of a busy machine are slow to end.
SOON_S = 1.0
BUSY_S = 2.0

BEGIN = """
import sys, time
sys.path.insert(0, {tests!r})
import musclewarp as mw
from conftest import *
def say(*words):
    print(*words, flush=True)
"""


def run(script, after_s, times=1):
    """Runs a script, and presses Ctrl-C `after_s` after it said "ready"."""
    process = subprocess.Popen(
        [sys.executable, "-c", BEGIN.format(tests=str(TESTS)) + script],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "ready\n"
    time.sleep(after_s)
    pressed = time.monotonic()
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=120)
    return process.returncode, out, err, time.monotonic() - pressed


@pytest.mark.parametrize("after_s", [0.1, 0.7, 2.0])
def test_stops_the_preparation_within_a_second(after_s):
    code, out, err, took = run(f"""
scene = mw.read_scene({str(DEMO)!r})
say("ready")
try:
    mw.run(scene)
except KeyboardInterrupt:
    say("caught", time.monotonic())
    raise
""", after_s)
    assert "caught" in out
    assert "KeyboardInterrupt" in err
    assert code in (-signal.SIGINT, 130)
    assert took < SOON_S + BUSY_S


def test_is_raised_at_once_and_leaves_the_deformer_as_it_was():
    code, out, err, _ = run("""
import signal, threading
scene = mw.read_scene(str(DEMO))
deformer = mw.Deformer(scene, coarse_vertices=60)
expected = deformer.move_to(scene.poses[0])["psoas_major_r"].points
deformer.reset()
say("ready")
pressed = None
def press():
    global pressed
    pressed = time.monotonic()
    signal.raise_signal(signal.SIGINT)
try:
    time.sleep(60)
except KeyboardInterrupt:
    pass
threading.Timer(0.05, press).start()
try:
    deformer.move_to(scene.poses[-1])
    say("too late")
except KeyboardInterrupt:
    say("took", time.monotonic() - pressed)
again = deformer.move_to(scene.poses[0])["psoas_major_r"].points
say("same", (again == expected).all())
""", 0.1)
    assert code == 0, err
    lines = out.splitlines()
    assert lines[0].startswith("took "), out
    assert float(lines[0].split()[1]) < SOON_S
    assert lines[1] == "same True"


def test_a_script_may_end_with_a_frame_and_threads_alive():
    script = """
import threading
deformer = quick()
frame = deformer.move_to(pushed(3))
threading.Thread(target=lambda: deformer.solve_alone(pushed(5))).start()
say("ready")
"""
    result = subprocess.run(
        [sys.executable, "-c", BEGIN.format(tests=str(TESTS)) + script],
        capture_output=True, text=True, timeout=120)
    assert result.returncode == 0, result.stderr
    assert result.stdout == "ready\n"


def test_the_wait_policy_of_the_user_stays():
    for given, expected in ((None, "passive"), ("active", "active")):
        environment = {k: v for k, v in os.environ.items()
                       if k != "OMP_WAIT_POLICY"}
        if given:
            environment["OMP_WAIT_POLICY"] = given
        said = subprocess.run(
            [sys.executable, "-c", "import os, musclewarp\n"
             "print(os.environ['OMP_WAIT_POLICY'])"],
            env=environment, capture_output=True, text=True, check=True)
        assert said.stdout.strip() == expected
