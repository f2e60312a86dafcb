# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Pictures of frames by pyvista, where it is installed."""
from typing import Any

from musclewarp import _core
from musclewarp._errors import InputError

_MUSCLE, _BONE = "#a8423f", "#e8dcc0"
_GAP = "gap"  # of the points that polydata() returns
_COLORS = ("kind", _GAP)


def _pyvista() -> Any:
    """ImportError if it is not installed: says what to install."""
    try:
        import pyvista
    except ImportError as error:
        raise ImportError(
            "plot() draws with pyvista, which is not installed; install it: "
            "pip install pyvista (without it, page() of a run shows the same "
            "in a browser)") from error
    return pyvista


def _add(pyvista: Any, plotter: Any, shown: Any, color_by: str) -> None:
    """Adds a muscle or a bone."""
    mesh, is_muscle = pyvista.wrap(shown.polydata()), isinstance(
        shown, _core.MuscleFrame)
    if is_muscle and color_by == _GAP:
        plotter.add_mesh(mesh, name=shown.name, scalars=_GAP,
                         scalar_bar_args={"title": "gap, mm"})
    else:
        plotter.add_mesh(mesh, name=shown.name,
                         color=_MUSCLE if is_muscle else _BONE)


def plot(self: Any,
         *,
         color_by: str = "kind",
         show: bool = True,
         **options: Any) -> Any:
    """Draws a frame, or one muscle or bone of it, with pyvista.

        frame.plot()
        frame.plot(color_by="gap", off_screen=True, show=False).screenshot("gap.png")

    A window opens, or a notebook shows the picture. Lengths are mm.

    Args:
        color_by: "kind" (muscles are red, bones ivory), or "gap" (muscles by the
            distance of each point to the nearest other mesh, mm).
        show: whether to show it, and wait until its window is closed. If not, the
            pyvista.Plotter is returned, to which more can be added.
        options: of pyvista.Plotter, such as off_screen=True, window_size=(800, 600).
    Returns:
        What Plotter.show() returns; with show=False, the Plotter.
    Raises:
        ImportError: pyvista is not installed.
        InputError: `color_by` is none of these.
    """
    if color_by not in _COLORS:
        raise InputError("color_by", f"is {color_by!r}",
                         'allowed: "kind", "gap"')
    pyvista = _pyvista()
    plotter = pyvista.Plotter(**options)
    parts = ([self[name] for name in self] if isinstance(self, _core.Frame)
             else [self])
    for part in parts:
        _add(pyvista, plotter, part, color_by)
    plotter.add_axes()
    return plotter.show() if show else plotter


def begin() -> None:
    """Gives frames, and the muscles and bones of them, the method plot()."""
    for shown in (_core.Frame, _core.MuscleFrame, _core.BoneFrame):
        setattr(shown, "plot", plot)
