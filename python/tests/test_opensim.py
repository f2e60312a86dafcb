# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""OpenSim models, motions and tables."""
import math

import numpy as np
import pytest

import musclewarp as mw
from conftest import DEMO, SOURCE

OSIM = str(SOURCE / "data/phantom/hip.osim")
MOT = str(SOURCE / "data/phantom/hip.mot")


@pytest.fixture(scope="module")
def model():
    return mw.read_model(OSIM)


def test_lists_its_parts(model):
    assert model.bodies[0] == "ground"
    assert "femur_r" in model.bodies
    assert "hip_flexion_r" in model.coordinates
    assert any("glut_med" in muscle for muscle in model.muscles)


def test_frames_of_bodies_are_rigid(model):
    frames = model.body_frames({"hip_flexion_r": 0.5})
    assert set(frames) == set(model.bodies)
    for frame in frames.values():
        np.testing.assert_allclose(frame[:3, :3].T @ frame[:3, :3], np.eye(3),
                                   atol=1e-12)
    np.testing.assert_array_equal(frames["ground"], np.eye(4))


def test_moment_arms_are_minus_the_slope_of_lengths(model):
    muscle, step = model.muscles[0], 1e-4

    def length(angle):
        return model.path_length(muscle, {"hip_flexion_r": angle})

    slope = (length(0.3 + step) - length(0.3 - step)) / (2 * step)
    arm = model.moment_arm(muscle, "hip_flexion_r", {"hip_flexion_r": 0.3})
    assert arm == pytest.approx(-slope, abs=1e-5)


def test_the_unit_of_angles_may_be_told(model):
    in_degrees = model.read_motion(MOT, in_degrees=True)
    in_radians = model.read_motion(MOT, in_degrees=False)
    for (_, degrees), (_, radians) in zip(in_degrees, in_radians):
        assert degrees["hip_flexion_r"] == pytest.approx(
            math.radians(radians["hip_flexion_r"]))


def test_path_points_are_those_of_the_length(model):
    muscle, pose = model.muscles[0], {"hip_flexion_r": 0.3}
    points = model.path_points(muscle, pose)
    sides = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert sides.sum() == pytest.approx(model.path_length(muscle, pose))


def test_motions_are_in_radians(model):
    table = mw.read_table(MOT)
    rows = model.read_motion(MOT)
    assert table.in_degrees is True
    np.testing.assert_array_equal([time for time, _ in rows], table.times)
    np.testing.assert_allclose(
        [row["hip_flexion_r"] for _, row in rows],
        np.radians(table["hip_flexion_r"]), rtol=1e-15)


def test_scenes_take_poses_of_their_model(model):
    scene = mw.read_scene(DEMO)
    time, coordinates = model.read_motion(MOT)[5]
    pose = scene.pose_of_model(coordinates, name="mine", time=time)
    assert (pose.name, pose.time) == ("mine", time)
    for name, motion in scene.poses[5].bodies.items():
        np.testing.assert_array_equal(pose.bodies[name], motion)
    for name, points in scene.poses[5].lines.items():
        np.testing.assert_array_equal(pose.lines[name], points)
    between = scene.pose_between(scene.poses[5], scene.poses[6], 0.5)
    angle = "hip_flexion_r"
    assert between.coordinates[angle] == pytest.approx(
        (scene.poses[5].coordinates[angle] +
         scene.poses[6].coordinates[angle]) / 2)


@pytest.mark.parametrize("call, words", [
    (lambda m: m.body_frames({"knee": 1}), 'coordinate "knee".*not in the'),
    (lambda m: m.body_frames({"hip_flexion_r": math.nan}), "is nan"),
    (lambda m: m.path_length("soleus", {}), 'muscle "soleus"'),
    (lambda m: m.moment_arm(m.muscles[0], "knee", {}), 'coordinate "knee"'),
    (lambda m: m.read_motion("missing.mot"), "missing.mot"),
    (lambda m: mw.read_model("missing.osim"), "missing.osim"),
    (lambda m: mw.Scene().pose_of_model({}), "has no model"),
    (lambda m: mw.read_scene(DEMO).pose_of_model({"knee": 1}), '"knee"'),
])
def test_what_is_not_there_is_named(model, call, words):
    with pytest.raises(mw.InputError, match=words):
        call(model)
