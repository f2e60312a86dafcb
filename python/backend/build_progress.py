# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Tells the terminal how far a build is.

pip shows what a build prints only with -v, or if it fails, and a build takes
minutes. Some lines therefore go to the terminal itself, if there is one.
"""
import re
import subprocess
import sys
import time

SECONDS_BETWEEN_LINES = 10
_STEPS = re.compile(r"\[ *(\d+)(?:/(\d+)|%)\]")  # as Ninja and make have them


def _terminal():
    """The terminal, unless there is none or it shows the output already."""
    if sys.stdout.isatty():
        return None
    try:
        return open("/dev/tty", "w")
    except OSError:
        return None


def _share_done(line):
    """How much of a build is done after the step of a line, in per cent."""
    steps = _STEPS.match(line)
    return steps and 100 * int(steps[1]) // int(steps[2] or 100)


def run_with_progress(command, cwd):
    """Runs a command, whose output it hands on; raises if that fails."""
    began = told = time.monotonic()
    terminal = _terminal()
    with subprocess.Popen(command, cwd=cwd, text=True, errors="replace",
                          stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT) as process:
        for line in process.stdout:
            print(line, end="", flush=True)
            now, done = time.monotonic(), _share_done(line)
            if terminal and done is not None and (
                    now - told >= SECONDS_BETWEEN_LINES):
                told = now
                # pip has left the cursor behind its own line.
                terminal.write(f"\r\nmusclewarp: {done} % is compiled after "
                               f"{now - began:.0f} s\r\n")
                terminal.flush()
    if terminal:
        terminal.close()
    if process.returncode:
        raise subprocess.CalledProcessError(process.returncode, command)
