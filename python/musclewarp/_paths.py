# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Lengths and moment arms as functions of joint coordinates."""
import os
from typing import Iterable, Union

from musclewarp import _core


def fit_paths(runs: Union[str, "os.PathLike[str]",
                          Iterable[Union[str, "os.PathLike[str]"]]],
              *,
              model: Union[str, "os.PathLike[str]"] = "",
              paths_per_muscle: int = 0) -> _core.PathFunctions:
    """Fits functions to the lengths and moment arms of written runs.

    They hold between the postures of the runs; best is a run of a design of
    postures (docs/motion.md). `Run.fit_paths()` does the same in memory.

    Args:
        runs: the folder of a run of musclewarp-deform, or several of one scene.
        model: an OpenSim model, in place of the one that the first run keeps.
        paths_per_muscle: 0 for the lines of the muscles; n for at most n bands
            of the fibres of each, which the runs must have (fibres=40).
    Returns:
        PathFunctions: lengths and moment arms of all paths.
    Raises:
        InputError: a run is not finished or has no moment arms, or the runs do
            not fit each other.
    """
    folders = [runs] if isinstance(runs, (str, os.PathLike)) else list(runs)
    return _core.fit_folders([os.fspath(folder) for folder in folders],
                             os.fspath(model), paths_per_muscle)
