# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Deforms a scene along its motion and writes what musclewarp-deform writes.

usage: deform_scene.py [--scene=SCENE.json] [--out=DIR] [--frames=N]

Without a scene it takes the hip that is inside the package.
"""
import argparse

import musclewarp as mw


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--scene", metavar="SCENE.json",
                        help="scene file [the hip inside the package]")
    parser.add_argument("--out", metavar="DIR",
                        help="folder to write to [nothing is written]")
    parser.add_argument("--frames", type=int, metavar="N",
                        help="how many of the motion, from the first on [all]")
    return parser.parse_args()


options = parse()
scene = mw.read_scene(options.scene) if options.scene else mw.demo_scene()
deformer = mw.Deformer(scene, gap=0.1)
run = mw.Run(deformer)
for pose in scene.poses[:options.frames]:
    frame = deformer.move_to(pose)
    run.append(frame)
    print(f"{frame.name}: {'usable' if frame.usable else frame.shortcomings}")
if options.out:
    run.write(options.out, format="ply")
