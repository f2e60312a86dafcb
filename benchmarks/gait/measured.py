#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs a program and writes its time and memory.

  benchmarks/gait/measured.py FIGURES.json COMMAND...

FIGURES.json has "wall_s", the time from start to end, and "peak_mb", the most memory
that the program had at once (1 MB = 1024 * 1024 bytes). Ends with the exit code of the
program.
"""

import json
import pathlib
import resource
import subprocess
import sys
import time


def measure(command):
    """Returns the exit code and the figures of a command."""
    started = time.monotonic()
    code = subprocess.run(command).returncode
    peak_kb = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    wall = time.monotonic() - started
    return code, {"wall_s": round(wall, 2), "peak_mb": round(peak_kb / 1024)}


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    code, figures = measure(sys.argv[2:])
    pathlib.Path(sys.argv[1]).write_text(json.dumps(figures) + "\n")
    return code if code >= 0 else 128 - code


if __name__ == "__main__":
    sys.exit(main())
