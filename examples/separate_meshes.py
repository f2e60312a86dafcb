# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Moves the vertices of overlapping meshes until no two cross.

usage: separate_meshes.py [--out=DIR] [--bones BONE.ply ...] [--muscles MUSCLE.ply ...]

Without muscles it takes the hip that is inside the package.
"""
import argparse
import pathlib
import sys

import musclewarp as mw


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--muscles", nargs="+", default=[], metavar="MUSCLE.ply",
                        help="meshes that move [the hip inside the package]")
    parser.add_argument("--bones", nargs="+", default=[], metavar="BONE.ply",
                        help="meshes that stay where they are")
    parser.add_argument("--out", metavar="DIR",
                        help="folder to write to [nothing is written]")
    options = parser.parse_args()
    if options.bones and not options.muscles:
        parser.error("--bones are given without --muscles; name muscles, too")
    return options


def read_meshes(files):
    return {pathlib.Path(f).stem: mw.read_mesh(f) for f in files}


options = parse()
if options.muscles:
    meshes, bones = read_meshes(options.muscles), read_meshes(options.bones)
else:
    scene = mw.demo_scene()
    meshes, bones = ({part.name: part.mesh for part in parts}
                     for parts in (scene.muscles, scene.bones))
frame = mw.separate(meshes, bones, gap=0.1)
if options.out:
    pathlib.Path(options.out).mkdir(parents=True, exist_ok=True)
    for name in frame:
        mw.write_mesh(f"{options.out}/{name}.ply", frame[name])
print("usable" if frame.usable else "\n".join(frame.shortcomings))
print(f"smallest gap: {frame.smallest_gap} mm, proved")
sys.exit(0 if frame.usable else 1)
