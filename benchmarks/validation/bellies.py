#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes the bellies of muscles of bodyparts3d_shank/uniform without their
tendons, as most segmentations have them; called by benchmarks/validation.sh.

  benchmarks/validation/bellies.py DATA OUT

Tendons are cut off by a horizontal plane, where a belly has become about as
thin as its tendon. The calcaneal tendon has a mesh of its own, so that the
muscles on it are as they are.
"""

import pathlib
import sys

import numpy as np

from slices import Cut

# The height of the cut, mm; None: whole.
BELLIES = {
    "extensor_digitorum_longus": 130,
    "extensor_hallucis_longus": 120,
    "fibularis_tertius": 85,
    "flexor_hallucis_longus": 95,
    "gastrocnemius_lateral": None,
    "gastrocnemius_medial": None,
    "plantaris": 365,
    "popliteus": None,
    "soleus": None,
    "tibialis_anterior": 165,
    "tibialis_posterior": 120,
}


def read_obj(path):
    """The points and the triangles of a Wavefront file."""
    points, triangles = [], []
    for line in path.read_text().splitlines():
        if line.startswith("v "):
            points.append([float(word) for word in line.split()[1:4]])
        elif line.startswith("f "):
            triangles.append([int(word.split("/")[0]) - 1 for word in line.split()[1:]])
    return np.array(points), np.array(triangles)


def write_obj(path, points, triangles):
    lines = ["v " + " ".join(f"{value:.6f}" for value in point) for point in points]
    lines += ["f " + " ".join(str(corner + 1) for corner in t) for t in triangles]
    path.write_text("\n".join(lines) + "\n")


def largest_piece(points, triangles):
    """The connected piece of a mesh with most points, without unused points."""
    piece = np.arange(len(points))
    while True:
        least = piece.copy()
        np.minimum.at(least, triangles, piece[triangles].min(axis=1)[:, None])
        if np.array_equal(least, piece):
            break
        piece = least[least]
    used = np.bincount(piece[np.unique(triangles)]).argmax()
    triangles = triangles[piece[triangles[:, 0]] == used]
    kept, corners = np.unique(triangles, return_inverse=True)
    return points[kept], corners.reshape(-1, 3)


def above(points, triangles, height):
    """The largest piece of a closed mesh above a height, closed."""
    cut = Cut(points, triangles, -points[:, 2], -height)
    return largest_piece(cut.extended(points), np.concatenate([cut.below, cut.fans]))


def main():
    data, out = (pathlib.Path(word) for word in sys.argv[1:])
    out.mkdir(parents=True, exist_ok=True)
    for name, height in BELLIES.items():
        mesh = read_obj(data / f"bodyparts3d_shank/uniform/{name}.obj")
        if height is not None:
            mesh = above(*mesh, height)
        write_obj(out / f"{name}.obj", *mesh)


if __name__ == "__main__":
    main()
