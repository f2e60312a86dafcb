# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Moment arms of an OpenSim model, and of the muscles that its motion deforms.

usage: moment_arms.py [--scene=SCENE.json] [--frames=N]

Without a scene it takes the hip that is inside the package.
"""
import argparse

import numpy as np

import musclewarp as mw


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--scene", metavar="SCENE.json",
                        help="scene file with a model [the hip inside the package]")
    parser.add_argument("--frames", type=int, metavar="N",
                        help="how many of the motion, from the first on [all]")
    return parser.parse_args()


options = parse()
scene = mw.read_scene(options.scene) if options.scene else mw.demo_scene()
run = mw.run(scene, scene.poses[:options.frames], coarse_vertices=100)
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
