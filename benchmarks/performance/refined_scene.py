#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes a scene of musclewarp-phantom once more with finer meshes.

  benchmarks/performance/refined_scene.py SCENE_FOLDER N OUT

Every edge is cut into N and every triangle into N * N, so that the surfaces stay
what they are. Lines and poses stay, too.
"""

import json
import pathlib
import sys

import numpy as np
import shared  # noqa: F401, where runs is
from runs import PLY_HEADER, read_ply


def small_triangles(n):
    """The N * N triangles of a triangle, their corners by weights that sum to n."""
    triangles = []
    for j in range(n):
        for k in range(n - j):
            i = n - j - k
            second, third = (i - 1, j + 1, k), (i - 1, j, k + 1)
            triangles.append([(i, j, k), second, third])
            if i > 1:
                triangles.append([second, (i - 2, j + 1, k + 1), third])
    return triangles


def refined(points, triangles, n):
    """Returns points, of which the given ones are first, and triangles."""
    numbers = {((vertex, n),): vertex for vertex in range(len(points))}
    small = small_triangles(n)
    cut = []
    for triangle in triangles.tolist():
        for corners in small:
            # What triangles share has the same key in each of them.
            keys = [
                tuple(sorted((v, w) for v, w in zip(triangle, weights) if w))
                for weights in corners
            ]
            cut.append([numbers.setdefault(key, len(numbers)) for key in keys])
    made = [sum(points[v] * (w / n) for v, w in key) for key in numbers]
    return np.array(made), np.array(cut)


def write_ply(path, points, triangles):
    face = np.dtype([("size", "u1"), ("corners", "<i4", 3)])
    faces = np.empty(len(triangles), face)
    faces["size"], faces["corners"] = 3, triangles
    header = PLY_HEADER.format(len(points), len(triangles)).encode()
    path.write_bytes(header + points.astype("<f8").tobytes() + faces.tobytes())


def write_refined_scene(source, n, out):
    scene = json.loads((source / "scene.json").read_text())
    out.mkdir(parents=True, exist_ok=True)
    for part in scene["muscles"] + scene["bones"]:
        write_ply(out / part["mesh"], *refined(*read_ply(source / part["mesh"]), n))
    (out / "scene.json").write_text(json.dumps(scene))


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    source, n, out = sys.argv[1:]
    write_refined_scene(pathlib.Path(source), int(n), pathlib.Path(out))


if __name__ == "__main__":
    main()
