# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Starts the programs of a wheel that carries its libraries.

The commands in bin/ of a virtual environment call main(). The program takes
the place of this process, so that arguments, signals and exit code are its own.
Imports nothing of the package, which would take longer than all else.
"""
import os
import signal
import sys

PROGRAMS = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                        "musclewarp", "bin")


def main():
    name = os.path.basename(sys.argv[0])
    program = os.path.join(PROGRAMS, name)
    # Python ignores these, and what it starts would, too.
    for ignored in (signal.SIGPIPE, signal.SIGXFSZ):
        signal.signal(ignored, signal.SIG_DFL)
    try:
        os.execv(program, [program, *sys.argv[1:]])
    except OSError as error:
        sys.exit(f"{name}: cannot start {program}: {error.strerror}")
