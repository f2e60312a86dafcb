# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Moves the vertices of overlapping meshes until no two cross.

usage: separate_meshes.py OUT MUSCLE.ply ... [--bones BONE.ply ...]
"""
import pathlib
import sys

import musclewarp as mw

out, *files = sys.argv[1:]
split = files.index("--bones") if "--bones" in files else len(files)
meshes, bones = ({pathlib.Path(f).stem: mw.read_mesh(f) for f in part}
                 for part in (files[:split], files[split + 1:]))
frame = mw.separate(meshes, bones, gap=0.1)
pathlib.Path(out).mkdir(parents=True, exist_ok=True)
for name in frame:
    mw.write_mesh(f"{out}/{name}.ply", frame[name])
print("usable" if frame.usable else "\n".join(frame.shortcomings))
print(f"smallest gap: {frame.smallest_gap} mm, proved")
sys.exit(0 if frame.usable else 1)
