# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""What has to happen before the library is loaded, and when Python ends."""
import atexit
import os
import sys

# Threads of OpenMP sleep while they wait for each other, unless the user has
# decided: to spin saves a few percent on an idle machine, but costs several
# times as much on a busy one. OpenMP reads this once, when it is loaded.
os.environ.setdefault("OMP_WAIT_POLICY", "passive")

# A computation that Ctrl-C has abandoned may go on for so long, s, once Python
# has nothing else to do. Nobody waits for it any more.
_PATIENCE_S = 0.5
_EXIT_CODE_OF_SIGINT = 130


def begin() -> None:
    """Sees to it that no computation outlives the interpreter."""
    from musclewarp import _core

    def end() -> None:
        if _core.wait_for_abandoned(_PATIENCE_S):
            return
        for stream in (sys.stdout, sys.stderr):
            try:
                stream.flush()
            except (AttributeError, OSError, ValueError):
                pass  # there is none, or nobody reads it
        # Libraries must not be unloaded while a thread is inside of them.
        os._exit(_EXIT_CODE_OF_SIGINT)

    atexit.register(end)
