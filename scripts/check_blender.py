# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Checks in Blender what musclewarp-export wrote of a run.

usage: blender --background --python-exit-code 1 --python scripts/check_blender.py -- \
           RUN MOTION.glb POINT_CACHE_DIR [FRAMES_PER_SECOND]

MOTION.glb and POINT_CACHE_DIR are exports of all frames of RUN, whose meshes are
.ply files. Blender has to give back every vertex of every frame to 1e-4 mm. With
FRAMES_PER_SECOND (default 100) the times of the frames are whole frames of Blender.
Works with Blender 3.4 of Debian 12 and 3.6.
"""

import json
import os
import sys

import numpy

# The glTF importer of Debian's Blender uses a name that its NumPy no longer has.
if "bool" not in numpy.__dict__:
    numpy.bool = bool

import bpy  # noqa: E402

TOLERANCE_MM = 1e-4


def read_ply(path):
    """Returns the points of a binary .ply file of musclewarp, in mm."""
    with open(path, "rb") as file:
        data = file.read()
    head = data.index(b"end_header\n") + len(b"end_header\n")
    lines = data[:head].decode().split("\n")
    count = int(next(line for line in lines if line.startswith("element vertex")).split()[-1])
    return numpy.frombuffer(data, "<f8", 3 * count, head).reshape(-1, 3)


def gltf_from(axes):
    """The matrix that takes the axes of the run to left, superior, anterior."""
    matrix = numpy.zeros((3, 3))
    for column, letter in enumerate(axes):
        for row in range(3):
            matrix[row, column] = (letter == "LSA"[row]) - (letter == "RIP"[row])
    return matrix


def world_points(evaluated):
    """Returns the vertices of an object in the world, computed in double precision."""
    mesh = evaluated.to_mesh()
    points = numpy.empty(3 * len(mesh.vertices), dtype=numpy.float32)
    mesh.vertices.foreach_get("co", points)
    points = points.reshape(-1, 3).astype(float)
    evaluated.to_mesh_clear()
    while evaluated is not None:
        location, rotation, _ = evaluated.matrix_local.decompose()
        turn = numpy.array(rotation.normalized().to_matrix(), dtype=float)
        points = points @ turn.T + numpy.array(location, dtype=float)
        evaluated = evaluated.parent
    return points


def frame_points(name, set_frame):
    set_frame()
    graph = bpy.context.evaluated_depsgraph_get()
    return world_points(bpy.data.objects[name].evaluated_get(graph))


def check(what, error_mm):
    print(f"{what}: {error_mm:.2e} mm")
    if not error_mm <= TOLERANCE_MM:
        sys.exit(f"{what}: off by {error_mm} mm, more than {TOLERANCE_MM} mm")


def check_glb(path, names, frames, expected, fps):
    scene = bpy.context.scene
    scene.render.fps = fps
    bpy.ops.import_scene.gltf(filepath=path)
    blender_from_gltf = numpy.array([[1, 0, 0], [0, 0, -1], [0, 1, 0]])
    start = frames[0]["time"]
    worst = 0
    for number, frame in enumerate(frames):
        at = (frame["time"] - start) * fps
        assert abs(at - round(at)) < 1e-6, f"{frame['time']} s is no whole frame"
        for name in names:
            found = frame_points(name, lambda: scene.frame_set(round(at)))
            wanted = expected(number, name) @ blender_from_gltf.T
            worst = max(worst, 1e3 * numpy.abs(found - wanted).max())
    check(f"{path}: {len(frames)} frames, {len(names)} meshes", worst)


def check_caches(folder, names, frames, expected):
    scene = bpy.context.scene
    worst = 0
    for name in names:
        bpy.ops.wm.obj_import(filepath=os.path.join(folder, name + ".obj"))
        item = bpy.context.selected_objects[0]
        cache = item.modifiers.new("cache", "MESH_CACHE")
        cache.cache_format = "PC2"
        cache.filepath = os.path.join(folder, name + ".pc2")
        cache.frame_start = 0
        for number in range(len(frames)):
            scene.frame_set(number)
            mesh = item.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
            points = numpy.empty(3 * len(mesh.vertices), dtype=numpy.float32)
            mesh.vertices.foreach_get("co", points)
            error = numpy.abs(points.reshape(-1, 3).astype(float) - expected(number, name))
            worst = max(worst, 1e3 * error.max())
        bpy.data.objects.remove(item)
    check(f"{folder}: {len(frames)} frames, {len(names)} meshes", worst)


def main():
    arguments = sys.argv[sys.argv.index("--") + 1 :]
    run, glb, caches = arguments[:3]
    fps = int(arguments[3]) if len(arguments) > 3 else 100
    with open(os.path.join(run, "report.json")) as file:
        report = json.load(file)
    prepare = report["prepare"]
    names = [mesh["name"] for mesh in prepare["muscles"] + prepare["bones"]]
    matrix = gltf_from(report["axes"])
    frames = report["frames"]

    def expected(number, name):
        folder = f"frame_{frames[number]['index']:04d}"
        return 1e-3 * read_ply(os.path.join(run, folder, name + ".ply")) @ matrix.T

    bpy.ops.wm.read_factory_settings(use_empty=True)
    check_glb(glb, names, frames, expected, fps)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    check_caches(caches, names, frames, expected)


main()
