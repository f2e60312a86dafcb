# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Deforms a scene along its motion and writes what musclewarp-deform writes.

usage: deform_scene.py SCENE.json OUT [FRAMES]
"""
import sys

import musclewarp as mw

scene = mw.read_scene(sys.argv[1])
poses = scene.poses[:int(sys.argv[3])] if len(sys.argv) > 3 else scene.poses
deformer = mw.Deformer(scene, gap=0.1)
run = mw.Run(deformer)
for pose in poses:
    frame = deformer.move_to(pose)
    run.append(frame)
    print(f"{frame.name}: {'usable' if frame.usable else frame.shortcomings}")
run.write(sys.argv[2], format="ply")
