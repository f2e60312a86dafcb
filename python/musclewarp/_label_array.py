# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Label images that are given as arrays."""
from typing import Any, List

import numpy as np

from musclewarp._errors import InputError

_LARGEST_LABEL = 2147483647


def label_array(image: Any) -> "np.ndarray[Any, Any]":
    """Returns an array of (i, j, k) whole numbers from 0 on, or raises."""
    array = np.asanyarray(image)
    if array.dtype.kind not in "biuf" or array.ndim != 3 or array.size == 0:
        raise InputError(
            "image", f"is an array of {array.dtype} and shape {array.shape}",
            "allowed: a file, an image of nibabel, or (i, j, k) numbers")
    low, high = array.min(), array.max()
    if not (low >= 0 and high <= _LARGEST_LABEL):
        raise InputError("image", f"has values from {low} to {high}",
                         f"allowed: labels from 0 to {_LARGEST_LABEL}")
    labels: "np.ndarray[Any, Any]" = array.astype(np.int32)
    if array.dtype.kind == "f" and not np.array_equal(labels, array):
        raise InputError("image", "has values that are no whole numbers",
                         "give a label map, not an image of intensities")
    return labels


def affine_rows(affine: Any) -> List[List[float]]:
    """Returns the rows of a (4, 4) matrix from indices to mm, or raises."""
    if affine is None:
        raise InputError("affine", "is missing",
                         "give (4, 4) numbers that take indices to mm")
    matrix = np.asarray(affine, dtype=np.float64)
    if matrix.shape != (4, 4) or not np.isfinite(matrix).all():
        raise InputError("affine", f"has the shape {matrix.shape}",
                         "allowed: (4, 4) finite numbers")
    if not np.array_equal(matrix[3], [0, 0, 0, 1]):
        raise InputError("affine", f"has the last row {matrix[3].tolist()}",
                         "allowed: 0, 0, 0, 1")
    rows: List[List[float]] = matrix.tolist()
    return rows
