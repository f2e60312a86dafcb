# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Objects that are pickled and copied are the same, bit for bit."""
import concurrent.futures
import copy
import multiprocessing
import pickle
import re

import numpy as np
import pytest

import musclewarp as mw
from conftest import pushed, quick, small_scene

WAYS = {
    "pickled": lambda thing: pickle.loads(pickle.dumps(thing)),
    "copied": copy.copy,
    "copied deeply": copy.deepcopy,
}
WAYS = [pytest.param(way, id=name) for name, way in WAYS.items()]


def assert_same_meshes(first, second):
    np.testing.assert_array_equal(first.points, second.points)
    np.testing.assert_array_equal(first.triangles, second.triangles)


def without_times(frame):
    return re.sub(r"[0-9.e+-]+ ms", "", str(frame))


def assert_same_frames(first, second):
    assert first.names == second.names
    assert without_times(first) == without_times(second)
    for name in first.names:
        assert_same_meshes(first[name], second[name])
    for a, b in zip(first.muscles, second.muscles):
        assert a.volume == b.volume and a.path_lengths == b.path_lengths
        assert len(a.lines) == len(b.lines) > 0
        for line, other in zip(a.lines, b.lines):
            np.testing.assert_array_equal(line, other)


@pytest.mark.parametrize("again", WAYS)
def test_meshes(again):
    mesh = small_scene().muscles[0].mesh
    assert_same_meshes(again(mesh), mesh)


@pytest.mark.parametrize("again", WAYS)
def test_poses(again):
    pose = mw.Pose("bent", time=0.1, bodies=pushed(3).bodies,
                   lines={"psoas": [(0, 0, 1), (0, 0, 2)]},
                   coordinates={"hip_flexion": 0.3})
    other = again(pose)
    assert (other.name, other.time) == ("bent", 0.1)
    assert other.coordinates == pose.coordinates
    np.testing.assert_array_equal(other.bodies["femur"], pose.bodies["femur"])
    np.testing.assert_array_equal(other.lines["psoas"], pose.lines["psoas"])


@pytest.mark.parametrize("again", WAYS)
def test_parts_of_scenes(again):
    line = again(mw.Line("l", [(0, 0, 0), (0, 0, 9)], ["a", "b"], slides=True))
    assert (line.name, line.bodies, line.slides) == ("l", ["a", "b"], True)
    area = again(mw.Attachment("femur", [(0, 0, 0)], 5, outline=True))
    assert (area.body, area.radius, area.outline) == ("femur", 5, True)
    bone = again(small_scene().bones[0])
    assert_same_meshes(bone.mesh, small_scene().bones[0].mesh)


@pytest.mark.parametrize("again", WAYS)
def test_scenes_lead_to_the_same_frames(again):
    scene = small_scene()
    other = again(scene)
    assert repr(other) == repr(scene)
    assert_same_frames(quick(scene).move_to(pushed(4)),
                       quick(other).move_to(pushed(4)))


@pytest.mark.parametrize("again", WAYS)
def test_scenes_keep_their_model(again):
    scene = mw.demo_scene()
    coordinate = next(iter(scene.poses[-1].coordinates))
    other = again(scene)
    assert other.notes == scene.notes
    first = scene.pose_of_model({coordinate: 0.2})
    second = other.pose_of_model({coordinate: 0.2})
    assert first.path_lengths == second.path_lengths
    for body, motion in first.bodies.items():
        np.testing.assert_array_equal(motion, second.bodies[body])


@pytest.mark.parametrize("again", WAYS)
def test_frames(again, deformer):
    deformer.reset()
    frame = deformer.move_to(pushed(5))
    assert_same_frames(again(frame), frame)
    assert_same_meshes(again(frame["psoas"]), frame["psoas"])
    assert_same_meshes(again(frame["femur"]), frame["femur"])


@pytest.mark.parametrize("again", WAYS)
def test_runs(again, deformer, tmp_path):
    run = mw.run(small_scene(), [pushed(1), pushed(4)], coarse_vertices=60)
    other = again(run)
    assert type(other) is mw.Run
    assert other.report()["frames"] == run.report()["frames"]
    np.testing.assert_array_equal(other.volumes.values, run.volumes.values)
    other.append(quick().solve_alone(pushed(6)))
    assert len(other.frames) == 3 and len(run.frames) == 2
    other.write(tmp_path / "run")
    assert mw.read_mesh(tmp_path / "run/frame_0002/psoas.ply")


def frame_of(scene, distance):
    return quick(scene).solve_alone(pushed(distance))


def test_frames_of_other_processes_join_a_run():
    scene = small_scene()
    run = mw.Run(quick(scene))
    with concurrent.futures.ProcessPoolExecutor(
            2, multiprocessing.get_context("spawn")) as pool:
        for frame in pool.map(frame_of, [scene] * 2, [2, 4]):
            run.append(frame)
    assert_same_frames(run.frames[1], run_of_one(scene, 4))


def run_of_one(scene, distance):
    """The frame as the second of a run."""
    run = mw.Run(quick(scene))
    for _ in range(2):
        run.append(frame_of(scene, distance))
    return run.frames[1]


@pytest.mark.parametrize("damage", [
    lambda state: state[:len(state) // 2],
    lambda state: state[:8] + b"0" * 16 + state[24:],
])
def test_damaged_states_are_refused(damage):
    mesh = small_scene().muscles[0].mesh
    state = mesh.__getstate__()
    with pytest.raises(mw.InputError, match="pickle"):
        type(mesh).__new__(type(mesh)).__setstate__(damage(state))
