#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""How long each folder took to compile, from the log that Ninja keeps.

    scripts/build_times.py [--build=build/release] [TARGET]

Prints a table of the folders whose sources TARGET is made of (musclewarp-deform,
which demo.sh builds, if none is named): the number of units, and the seconds
that they took in the last build of each. They are seconds on the clock of steps
that ran beside others, so that shares tell more than sums.
"""
import argparse
import collections
import pathlib
import re
import subprocess


def seconds_of_outputs(build):
    """The seconds of each output, when it was last made."""
    seconds = {}
    for line in (build / ".ninja_log").read_text().splitlines():
        if line.startswith("#"):
            continue
        begin, end, _, output, _ = line.split("\t")
        seconds[output] = (int(end) - int(begin)) / 1000
    return seconds


def inputs_of(build, target):
    listed = subprocess.run(["ninja", "-C", build, "-t", "inputs", target],
                            check=True, text=True, stdout=subprocess.PIPE)
    return listed.stdout.splitlines()


def folder_of(path):
    """src/musclewarp/run of .../run/CMakeFiles/musclewarp_run.dir/unity_0.o"""
    return re.sub(r"/CMakeFiles/.*", "", path)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default="build/release")
    parser.add_argument("target", nargs="?", default="musclewarp-deform")
    options = parser.parse_args()

    seconds = seconds_of_outputs(options.build)
    units = collections.Counter()
    total = collections.Counter()
    for path in inputs_of(options.build, options.target):
        if not path.endswith((".o", ".gch")) or path not in seconds:
            continue
        units[folder_of(path)] += 1
        total[folder_of(path)] += seconds[path]
    print("| folder | units | s |\n|---|---|---|")
    for folder, took in total.most_common():
        print(f"| `{folder}` | {units[folder]} | {took:.0f} |")
    print(f"| all | {units.total()} | {total.total():.0f} |")


if __name__ == "__main__":
    main()
