# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Files that appear complete or not at all, and locks on folders."""
import contextlib
import fcntl
import os
import pathlib


def write_atomically(path, text):
    """Writes beside the file, under a hidden name, and renames at the end."""
    path = pathlib.Path(path)
    partial = path.with_name(f".{path.name}.{os.getpid()}.partial")
    try:
        partial.write_text(text, encoding="utf-8")
        os.replace(partial, path)
    finally:
        partial.unlink(missing_ok=True)


@contextlib.contextmanager
def locked(path, wait):
    """Holds the lock of a file, and yields its descriptor. The lock is held
    until every process that inherits the descriptor has ended, killed or not.
    BlockingIOError if another holds it and `wait` is false."""
    with open(path, "a", encoding="utf-8") as file:
        fcntl.flock(file, fcntl.LOCK_EX | (0 if wait else fcntl.LOCK_NB))
        yield file.fileno()
