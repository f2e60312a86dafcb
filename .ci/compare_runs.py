#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Prints how far the meshes of two runs of one scene are apart, vertex by vertex.

usage: .ci/compare_runs.py RUN RUN

Reads frame_*/*.ply of both. Exits with 1 if their files, or the numbers of
vertices of these, are not the same.
"""
import array
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


def distance(one, other):
    """The largest and the mean distance of two lists of vertices, mm."""
    lengths = [math.dist(one[i:i + 3], other[i:i + 3])
               for i in range(0, len(one), 3)]
    return max(lengths), sum(lengths) / len(lengths)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    runs = [pathlib.Path(name) for name in sys.argv[1:]]
    names = [sorted(str(path.relative_to(run))
                    for path in run.glob("frame_*/*.ply")) for run in runs]
    if names[0] != names[1] or not names[0]:
        sys.exit(f"the runs have other files: {len(names[0])} and "
                 f"{len(names[1])} in frame_*/*.ply")
    worst = {}
    for name in names[0]:
        one, other = (vertices(run / name) for run in runs)
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
