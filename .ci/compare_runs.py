#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Prints how far the meshes of two runs of one scene are apart, vertex by vertex.

usage: .ci/compare_runs.py RUN RUN

Reads frame_*/*.ply of both, and the bones of frames that have bones.json instead
(docs/motion.md). Exits with 1 if their meshes, or the numbers of vertices of
these, are not the same.
"""
import array
import json
import math
import pathlib
import re
import sys


def vertices(path):
    """The coordinates of the vertices of a .ply file with doubles, one by one."""
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode("ascii")
    if "binary_little_endian" not in header or "property double z" not in header:
        sys.exit(f"{path}: is not a binary .ply file with doubles")
    count = int(re.search(r"element vertex (\d+)", header)[1])
    return array.array("d", data[end:end + 24 * count])


def moved(points, motion):
    """The coordinates of vertices after a rigid motion, a 4 x 4 matrix."""
    return [sum(row[k] * points[i + k] for k in range(3)) + row[3]
            for i in range(0, len(points), 3) for row in motion[:3]]


def meshes(run):
    """How to read the vertices of the meshes of a run, by their paths in frames."""
    found = {str(path.relative_to(run)): lambda path=path: vertices(path)
             for path in run.glob("frame_*/*.ply")}
    for path in run.glob("frame_*/bones.json"):
        for name, motion in json.loads(path.read_text())["bones"].items():
            rest = run / "rest" / f"{name}.ply"
            found[f"{path.parent.name}/{name}.ply"] = (
                lambda rest=rest, motion=motion: moved(vertices(rest), motion))
    return found


def distance(one, other):
    """The largest and the mean distance of two lists of vertices, mm."""
    lengths = [math.dist(one[i:i + 3], other[i:i + 3])
               for i in range(0, len(one), 3)]
    return max(lengths), sum(lengths) / len(lengths)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    runs = [meshes(pathlib.Path(name)) for name in sys.argv[1:]]
    if runs[0].keys() != runs[1].keys() or not runs[0]:
        sys.exit(f"the runs have other meshes: {len(runs[0])} and "
                 f"{len(runs[1])} in their frames")
    worst = {}
    for name in sorted(runs[0]):
        one, other = (run[name]() for run in runs)
        if len(one) != len(other):
            sys.exit(f"{name}: {len(one) // 3} and {len(other) // 3} vertices")
        largest, mean = distance(one, other)
        mesh = pathlib.Path(name).stem
        before = worst.get(mesh, (0, 0, ""))
        worst[mesh] = max(before, (largest, mean, pathlib.Path(name).parent.name))
    for mesh, (largest, mean, frame) in sorted(worst.items()):
        print(f"{mesh}: at most {largest:.3g} mm apart, {mean:.3g} mm on the "
              f"mean of that frame ({frame or 'all frames'})")


if __name__ == "__main__":
    main()
