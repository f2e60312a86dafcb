# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Meshes as those of VTK, where its Python modules are."""
from typing import Any

import numpy as np

from musclewarp import _core
from musclewarp._errors import InputError


def polydata(shown: Any) -> Any:
    """Returns the vtkPolyData of a muscle or bone of a frame.

    Of a frame, it returns a dict of them by name. They are copies, to be changed
    at will. The points of muscles carry "gap", mm.
    """
    if isinstance(shown, _core.Frame):
        return {name: polydata(shown[name]) for name in shown}
    try:
        from vtkmodules.util.numpy_support import (numpy_to_vtk,
                                                   numpy_to_vtkIdTypeArray)
        from vtkmodules.vtkCommonCore import vtkPoints
        from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    except ImportError as error:
        raise InputError("polydata()", "VTK's Python modules are not here",
                         "install them (Debian: python3-vtk9)") from error
    result = vtkPolyData()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(shown.points, deep=True))
    result.SetPoints(points)
    triangles = np.asarray(shown.triangles, dtype=np.int64)
    offsets = np.arange(0, 3 * len(triangles) + 1, 3, dtype=np.int64)
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(triangles.ravel(), deep=True))
    result.SetPolys(cells)
    if isinstance(shown, _core.MuscleFrame):
        gaps = numpy_to_vtk(shown.gaps, deep=True)
        gaps.SetName("gap")
        result.GetPointData().AddArray(gaps)
    return result
