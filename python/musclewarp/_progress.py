# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Progress of long computations: functions, and bars such as those of tqdm."""
from typing import Any, Callable, Optional, Union

# Called with what is being done ("preparing"), how many parts of it are done,
# and how many there are (0: not known). It may raise to stop the computation.
ProgressFunction = Callable[[str, int, int], Any]

# A function, or a bar as tqdm makes them.
Progress = Union[ProgressFunction, Any, None]


def as_function(progress: Progress) -> Optional[ProgressFunction]:
    """Returns the function that `progress` is, or that moves the bar."""
    if progress is None or callable(progress):
        return progress
    for name in ("update", "reset", "set_description"):
        if not callable(getattr(progress, name, None)):
            raise TypeError(
                "progress is neither a function of (stage, done, total) nor a "
                f"bar as tqdm makes them: it has no {name}()")
    return _BarMover(progress)


class _BarMover:
    """Shows every stage of a computation on one bar."""

    def __init__(self, bar: Any) -> None:
        self._bar = bar
        self._stage = ""
        self._total = -1

    def __call__(self, stage: str, done: int, total: int) -> None:
        bar = self._bar
        if (stage, total) != (self._stage, self._total) or done < bar.n:
            self._stage, self._total = stage, total
            bar.reset(total=total or None)
            bar.set_description(stage)
        bar.update(done - bar.n)
