# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Says what is wrong with meshes, by themselves and with each other.

usage: check_meshes.py [MESH.ply ...]

Without meshes it takes those of the hip that is inside the package.
"""
import argparse
import itertools
import pathlib

import musclewarp as mw


def parse():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("meshes", nargs="*", metavar="MESH.ply",
                        help="without any: the hip inside the package")
    return parser.parse_args()


def read_meshes(files):
    if not files:
        scene = mw.demo_scene()
        return {part.name: part.mesh for part in scene.muscles + scene.bones}
    return {pathlib.Path(f).stem: mw.read_mesh(f) for f in files}


meshes = read_meshes(parse().meshes)
for name, mesh in meshes.items():
    found = {key: value for key, value in mesh.defects().items()
             if key.endswith(("points", "triangles", "edges")) and value}
    repaired, report = mw.repair(mesh, name=name)
    print(f"{name}: {repaired.volume / 1000:.1f} cm^3, defects: {found}, "
          f"{len(mw.self_crossings(mesh))} self-crossings")
for (a, first), (b, second) in itertools.combinations(meshes.items(), 2):
    found = mw.crossings(first, second)
    if found:
        print(f"{a} and {b}: {len(found.triangle_pairs)} pairs of triangles "
              f"cross, {max(found.a_depth, found.b_depth):.1f} mm deep")
