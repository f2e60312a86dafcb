# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""How the joints of the shared right leg (BodyParts3D: +x left, +y posterior, +z up,
mm) move its bodies. Motions are 4 x 4, target_from_rest."""

import json

import numpy as np

TOLERANCE = 1e-3  # between own and given poses, whose numbers are rounded, mm
POSES = {  # of the data: data set, name, angles in degrees, body
    "bodyparts3d": [
        ("flexion_20", {"hip": 20}, "femur"),
        ("flexion_45", {"hip": 45}, "femur"),
        ("extension_10", {"hip": -10}, "femur"),
    ],
    "bodyparts3d_shank": [
        ("knee_30", {"knee": 30}, "tibia"),
        ("knee_60", {"knee": 60}, "tibia"),
        ("dorsiflexion_20", {"ankle": 20}, "foot"),
        ("plantarflexion_40", {"ankle": -40}, "foot"),
        ("knee_30_plantarflexion_20", {"knee": 30, "ankle": -20}, "foot"),
        ("knee_60_dorsiflexion_20", {"knee": 60, "ankle": 20}, "foot"),
    ],
}


def turn(point, axis, degrees):
    """The rotation about an axis through a point, right-handed."""
    x, y, z = np.asarray(axis) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.radians(degrees)
    motion = np.eye(4)
    motion[:3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    motion[:3, 3] = point - motion[:3, :3] @ point
    return motion


def moved(motion, point):
    return motion[:3, :3] @ point + motion[:3, 3]


class Leg:
    """Hip, knee and ankle of the data sets in a folder."""

    def __init__(self, data):
        joints, self.given = {}, {}
        for name in POSES:
            read = json.loads((data / name / "joints.json").read_text())
            joints.update(read)
            poses = json.loads((data / name / "poses.json").read_text())["poses"]
            self.given.update({pose["name"]: pose for pose in poses})
        self.hip_center = np.array(joints["hip_r"]["center"])
        knee, ankle = joints["knee_r"], joints["ankle_r"]
        self.knee_point = np.array(knee["point"])
        self.knee_axis = np.array(knee["direction_lateral_to_medial"])
        self.ankle_point = np.array(ankle["lateral_malleolus_tip"])
        self.ankle_axis = np.array(ankle["direction_lateral_to_medial"])
        self.knee_shifts = [self._given_shift(degrees) for degrees in (30, 60)]

    def _given_shift(self, degrees):
        """How far a pose of the data moves the tibia along its shaft, mm."""
        given = np.array(self.given[f"knee_{degrees}"]["tibia"])
        rotation = turn(self.knee_point, self.knee_axis, degrees)
        return (given - rotation)[:3, 3] @ rotation[:3, 2]

    def femur_of_pelvis(self, flexion):
        """Hip flexion, degrees, about +x through the centre of the head."""
        return turn(self.hip_center, [1, 0, 0], -flexion)

    def tibia_of_femur(self, flexion):
        """Knee flexion, degrees, about the axis of the condyles, then along the
        shaft: by the parabola through rest and the poses of the data, which keep
        the gap between the bones."""
        motion = turn(self.knee_point, self.knee_axis, flexion)
        t, (at_30, at_60) = flexion / 30, self.knee_shifts
        shift = t * (2 - t) * at_30 + t * (t - 1) / 2 * at_60
        motion[:3, 3] += shift * motion[:3, 2]
        return motion

    def foot_of_tibia(self, dorsiflexion):
        """Ankle dorsiflexion, degrees, about the line of the malleoli."""
        return turn(self.ankle_point, self.ankle_axis, -dorsiflexion)

    def bodies(self, fixed, hip=0, knee=0, ankle=0):
        """The motions of femur, tibia and foot; `fixed` is pelvis or femur."""
        femur = np.eye(4) if fixed == "femur" else self.femur_of_pelvis(hip)
        tibia = femur @ self.tibia_of_femur(knee)
        return {
            "femur": femur,
            "tibia": tibia,
            "foot": tibia @ self.foot_of_tibia(ankle),
        }


def first_vertex(path):
    """A point of an .obj file."""
    with open(path, encoding="utf-8") as file:
        words = next(line for line in file if line.startswith("v ")).split()
    return np.array(words[1:4], float)


def check_leg(leg, data):
    """Raises ValueError unless the leg reaches the poses of the data, and its joints
    move its bones the right way."""
    for name, poses in POSES.items():
        fixed = "pelvis" if name == "bodyparts3d" else "femur"
        for pose, angles, body in poses:
            given = np.array(leg.given[pose][body])
            error = np.abs(leg.bodies(fixed, **angles)[body] - given).max()
            if error > TOLERANCE:
                raise ValueError(f"{data / name}: {pose} is {error:.2g} off")
    toe = first_vertex(data / "bodyparts3d_shank/uniform/toe_1_distal.obj")
    heel = leg.ankle_point  # beside it
    moves = {
        "hip flexion does not bring the knee forward": -(
            moved(leg.femur_of_pelvis(30), leg.knee_point) - leg.knee_point
        )[1],
        "knee flexion does not bring the heel back": (
            moved(leg.tibia_of_femur(30), heel) - heel
        )[1],
        "dorsiflexion does not lift the toes": (
            moved(leg.foot_of_tibia(10), toe) - toe
        )[2],
    }
    for complaint, way in moves.items():
        if way <= 0:
            raise ValueError(f"{data}: {complaint}")
