#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes a scene of one gait cycle of the shared thigh or shank.

  benchmarks/gait/gait_scene.py DATA thigh|shank SCENE.json

Muscles and bones are those of the scene for poses, whose muscles get their lines from
the meshes; only the poses are others: 100 frames from gait_angles.csv, added to the
pose in which the bodies were segmented. Meshes are found with --data_root=DATA. In
the thigh the pelvis stays, in the shank the femur.
"""

import json
import pathlib
import sys

from gait_cycle import PERIOD, gait_cycle
from leg import Leg, check_leg

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
MOVING = {"thigh": ("femur", "tibia"), "shank": ("tibia", "foot")}
FIXED = {"thigh": "pelvis", "shank": "femur"}


def source_of(data, name):
    if name == "thigh":
        return REPOSITORY / "data/scenes/bodyparts3d_thigh.json"
    return data / "bodyparts3d_shank/scene_uniform.json"


def poses_of(leg, name, frames):
    """The poses of a scene, with times in s."""
    poses = []
    for frame in frames:
        angles = {"hip": frame.hip, "knee": frame.knee, "ankle": frame.ankle}
        bodies = leg.bodies(FIXED[name], **angles)
        poses.append({
            "name": f"gait_{frame.percent:02.0f}",
            "time": frame.percent / 100 * PERIOD,
            "bodies": {body: bodies[body].tolist() for body in MOVING[name]},
        })
    return poses


def write_scene(data, name, path):
    """Returns a sentence about angles that were limited, or none."""
    leg = Leg(data)
    check_leg(leg, data)
    scene = json.loads(source_of(data, name).read_text())
    frames, outside = gait_cycle()
    scene["name"] = f"gait_{name}"
    del scene["poses_file"]
    scene["poses"] = poses_of(leg, name, frames)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(scene, indent=1) + "\n")
    cut = [f"{joint} in {count} frames" for joint, count in outside.items() if count]
    return f"limited to the range of the scenes: {', '.join(cut)}" if cut else ""


def main():
    if len(sys.argv) != 4 or sys.argv[2] not in MOVING:
        sys.exit(__doc__)
    data, name, path = sys.argv[1:]
    try:
        said = write_scene(pathlib.Path(data), name, pathlib.Path(path))
    except (ValueError, KeyError, OSError) as error:
        sys.exit(f"gait: {error}")
    if said:
        print(f"gait: {said}")


if __name__ == "__main__":
    main()
