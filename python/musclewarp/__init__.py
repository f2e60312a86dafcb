# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Deforms the muscles of a musculoskeletal model as its bones move.

    import musclewarp as mw

    scene = mw.read_scene("hip.json", data_root="data")
    deformer = mw.Deformer(scene, gap=0.1)
    for pose in scene.poses:
        frame = deformer.move_to(pose)
        print(frame.usable, frame.shortcomings, frame["psoas"].points)

Lengths are in millimetres, angles in radians, unless a name says otherwise.
Arrays of points are (n, 3) float64, of triangles (m, 3) int32. Arrays that the
package returns show its own numbers without a copy; they are read-only and stay
valid as long as they are used. What the package is given is copied, and may be
anything that numpy makes such an array of. Bad input raises InputError.
"""
from musclewarp import _lifetime  # first, see there
from musclewarp import _plot
from musclewarp._core import (Attachment, Bone, BoneFrame, Crossings, Frame,
                              Joint, Line, Mesh, Model, Muscle, MuscleFrame,
                              PathFunction, PathFunctions, Pose,
                              State, Table, __version__, crossings, read_model,
                              read_mesh, read_table, self_crossings,
                              set_threads, threads, write_mesh)
from musclewarp._deformer import Deformer, Run, run
from musclewarp._errors import InputError
from musclewarp._functions import repair, separate
from musclewarp._joints import Articulation, articulate
from musclewarp._labels import Labels, read_labels
from musclewarp._page import Page, page
from musclewarp._paths import fit_paths
from musclewarp._scene import Scene, demo_scene, read_scene

__all__ = [
    "Articulation", "Attachment", "Bone", "BoneFrame", "Crossings", "Deformer",
    "Frame", "InputError", "Joint", "Labels", "Line", "Mesh", "Model", "Muscle", "MuscleFrame", "Page",
    "PathFunction", "PathFunctions",
    "Pose", "Run", "Scene", "State", "Table", "__version__", "articulate",
    "crossings",
    "demo_scene", "fit_paths", "page", "read_labels", "read_mesh", "read_model", "read_scene", "read_table", "repair",
    "run", "self_crossings", "separate", "set_threads", "threads", "write_mesh"
]

_lifetime.begin()
_plot.begin()
for _class in (Attachment, Bone, BoneFrame, Crossings, Frame, Joint, Line,
               Mesh, Model,
               Muscle, MuscleFrame, PathFunction, PathFunctions, Pose, State,
               Table):
    _class.__module__ = "musclewarp"
