# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Moment arms of an OpenSim model, and of the muscles that its motion deforms.

usage: moment_arms.py SCENE.json [FRAMES]
"""
import sys

import numpy as np

import musclewarp as mw

scene = mw.read_scene(sys.argv[1])
frames = int(sys.argv[2]) if len(sys.argv) > 2 else len(scene.poses)
run = mw.run(scene, scene.poses[:frames], coarse_vertices=100)
arms = run.moment_arms  # m, of lines as muscles carry them and as straight
for label in arms.labels:
    if "_path." not in label:
        continue
    carried = label.replace("_path.", ".")
    straight_mm = 1000 * np.asarray(arms[label])
    text = f"{label}: {straight_mm.min():.1f} to {straight_mm.max():.1f} mm"
    if carried in arms:
        text += f", as carried {1000 * np.mean(arms[carried]):.1f} mm on average"
    print(text)
