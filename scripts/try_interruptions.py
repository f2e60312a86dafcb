#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Interrupts musclewarp-deform at random moments, resumes it until it ends, and
compares what it wrote with a run that was left alone, byte by byte.

  scripts/try_interruptions.py --build=build/release --out=DIR --moments=50 \\
      -- --scene=FILE [flags of musclewarp-deform]

Each moment is a drawn share of the time of the whole run, and one of SIGKILL,
SIGINT and SIGTERM. A third of the runs that are resumed are interrupted once
more. A program that ends by itself after SIGINT or SIGTERM has to say how to go
on. Two runs in one folder are tried last: one of them has to be refused, and the
other to be whole. Without flags behind "--" the scene is the embedded one.

Exit code: 0 if every run came to the same bytes, else 1.
"""

import argparse
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import time

from run_contents import contents, difference

WHAT_TO_DO = ["--resume goes on from there", "nothing was written"]

SIGNALS = [signal.SIGKILL, signal.SIGINT, signal.SIGTERM]


class Deform:
    """A run of musclewarp-deform that is going on."""

    def __init__(self, options, out, *, resume=False):
        command = [options.build / "tools/musclewarp-deform", *options.flags,
                   f"--out={out}"]
        self.began = time.monotonic()
        self.process = subprocess.Popen(
            [str(word) for word in command] + ["--resume"] * resume,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
            env={"OMP_WAIT_POLICY": "passive", **os.environ})

    def interrupt(self, moment, number):
        """Sends a signal after `moment` seconds; returns whether it came before
        the end of the run."""
        try:
            self.process.wait(max(0, self.began + moment - time.monotonic()))
            return False
        except subprocess.TimeoutExpired:
            self.process.send_signal(number)
            return True

    def end(self):
        """Returns the exit code and what was said."""
        said = self.process.communicate()[0]
        return self.process.returncode, said.strip()


def complaint(number, code, said):
    """Returns what is wrong with the end of a run that had a signal, or ""."""
    if number == signal.SIGKILL:
        return "" if code == -number else f"exit code {code} after SIGKILL"
    if code in (0, 1) or code == -number or code == 128 + number:
        is_told = any(words in said for words in WHAT_TO_DO)
        return "" if code == 0 or is_told else (
            f"exit code {code}, but not how to go on: {said[-200:]}")
    return f"exit code {code}: {said[-200:]}"


def try_moment(options, expected, duration, draw):
    """Returns what was done, and what is wrong with it, or ""."""
    out = options.out / "run"
    shutil.rmtree(out, ignore_errors=True)
    done, resume = [], False
    while True:
        number = draw.choice(SIGNALS)
        moment = draw.uniform(0, 1) * duration
        is_left_alone = resume and draw.random() > 1 / 3
        run = Deform(options, out, resume=resume and out.exists())
        hit = not is_left_alone and run.interrupt(moment, number)
        code, said = run.end()
        if not hit:
            break
        done.append(f"{signal.Signals(number).name} after {moment:.2f} s")
        wrong = complaint(number, code, said)
        if wrong:
            return ", ".join(done), wrong
        resume = True
    what = ", ".join(done) or "came to its end before the signal"
    if code not in (0, 1):
        return what, f"exit code {code}: {said[-200:]}"
    return what, difference(expected, contents(out))


def try_two_runs(options, expected):
    """Starts two runs in one folder. Returns what is wrong, or ""."""
    out = options.out / "run"
    shutil.rmtree(out, ignore_errors=True)
    ends = [run.end() for run in [Deform(options, out), Deform(options, out)]]
    refused = [said for code, said in ends if code == 2]
    if len(refused) != 1:
        return f"exit codes {[code for code, _ in ends]}"
    if str(out) not in refused[0]:
        return f"the message does not name the folder: {refused[0]}"
    return difference(expected, contents(out))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--moments", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("flags", nargs="*", metavar="FLAG",
                        help="flags of musclewarp-deform, behind --")
    options = parser.parse_args()
    options.flags = options.flags or ["--demo"]
    options.out.mkdir(parents=True, exist_ok=True)
    whole = options.out / "whole"
    shutil.rmtree(whole, ignore_errors=True)
    began = time.monotonic()
    code, said = Deform(options, whole).end()
    if code not in (0, 1):
        sys.exit(f"try_interruptions: exit code {code}: {said}")
    duration = time.monotonic() - began
    expected = contents(whole)
    print(f"left alone: {len(expected)} files in {duration:.1f} s", flush=True)
    draw = random.Random(options.seed)
    failures = 0
    for number in range(1, options.moments + 1):
        what, wrong = try_moment(options, expected, duration, draw)
        failures += bool(wrong)
        print(f"{number}: {what}: {wrong or 'the same bytes'}", flush=True)
    wrong = try_two_runs(options, expected)
    failures += bool(wrong)
    print(f"two runs in one folder: {wrong or 'one refused, the other whole'}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
