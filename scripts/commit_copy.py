# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""A copy of the last commit in which scripts change sources and build, while the
sources themselves stay as they are. It is kept for the next run, of any of these
scripts; two of them at a time would disturb each other."""

import contextlib
import pathlib
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
COPY = ROOT / "build" / "mutants"


def check_out():
    """Makes the copy, or brings it to the last commit."""
    commit = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout.strip()
    if not (COPY / ".git").exists():
        subprocess.run(["git", "worktree", "add", "--detach", COPY, commit],
                       cwd=ROOT, check=True)
    subprocess.run(["git", "checkout", "--quiet", "--force", commit], cwd=COPY,
                   check=True)


def configure_and_build(preset, targets):
    subprocess.run([COPY / "scripts/build.sh", preset, *targets], check=True)


def run(command, timeout=None):
    """Returns whether a command succeeds within the time, and how long it
    takes."""
    began = time.monotonic()
    try:
        done = subprocess.run(command, cwd=COPY, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, timeout=timeout,
                              check=False)
        return done.returncode == 0, time.monotonic() - began
    except subprocess.TimeoutExpired:
        return False, time.monotonic() - began


def builds(targets):
    """Returns whether what is in the copy now compiles."""
    return run(["cmake", "--build", "build/release", "--target", *targets])[0]


@contextlib.contextmanager
def changed(file, change):
    """Within it, a file of the copy is what `change` makes of its text."""
    path = COPY / file
    text = path.read_text(encoding="utf-8")
    path.write_text(change(text), encoding="utf-8")
    try:
        yield
    finally:
        path.write_text(text, encoding="utf-8")
