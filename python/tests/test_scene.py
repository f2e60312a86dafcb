# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Scenes: what is read, put together and changed."""
import json

import numpy as np
import pytest

import musclewarp as mw
from conftest import DEMO, muscle, pushed, quick, small_scene, spindle


def test_a_scene_is_read_with_all_its_parts():
    scene = mw.read_scene(DEMO)
    assert scene.name == "hip_motion" and scene.is_motion
    assert [m.name for m in scene.muscles][0] == "gluteus_medius_r"
    assert scene.muscles[0].mesh.points.shape[1] == 3
    assert scene.muscles[0].lines[0].bodies[0] == "pelvis"
    assert scene.muscles[0].attachments[0].points.shape == (24, 3)
    assert {bone.body for bone in scene.bones} == {"pelvis", "femur_r"}
    assert len(scene.poses) == 15
    assert scene.path == str(DEMO)


def test_a_motion_may_be_in_the_scene_file(tmp_path):
    of_file = mw.read_scene(DEMO)
    text = json.loads(DEMO.read_text())
    text["motion"] = {"frames": 15,
                      "coordinates": {"hip_flexion_r": [-10, 60]}}
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(text))
    scene = mw.read_scene(path, data_root=DEMO.parent)
    assert scene.is_motion
    assert [pose.time for pose in scene.poses] == [k / 14 for k in range(15)]
    for pose, expected in zip(scene.poses, of_file.poses):
        assert pose.coordinates == expected.coordinates
    again = mw.read_scene(path, data_root=DEMO.parent, motion="hip.mot")
    assert [pose.time for pose in again.poses] == [
        pose.time for pose in of_file.poses]
    text["motion"]["coordinates"] = {"hip_flexoin_r": [-10, 60]}
    path.write_text(json.dumps(text))
    with pytest.raises(mw.InputError, match=r"did you mean hip_flexion_r\?"):
        mw.read_scene(path, data_root=DEMO.parent)


def test_what_cannot_be_read_is_named(tmp_path):
    with pytest.raises(mw.InputError, match="missing.json"):
        mw.read_scene(tmp_path / "missing.json")
    path = tmp_path / "scene.json"
    path.write_text('{"name": "x", "units": "mm", "muscels": []}')
    with pytest.raises(mw.InputError, match="muscels"):
        mw.read_scene(path)


def test_a_scene_of_files_is_that_of_arrays(tmp_path):
    scene = small_scene()
    arrays = quick(scene).solve_alone(pushed(5))
    path = str(tmp_path / "psoas.ply")
    mw.write_mesh(path, mw.Mesh(*spindle(0)))
    scene.muscles[0] = mw.Muscle("psoas", path=path,
                                 lines=scene.muscles[0].lines)
    files = quick(scene).solve_alone(pushed(5))
    np.testing.assert_array_equal(files["psoas"].points,
                                  arrays["psoas"].points)
    np.testing.assert_array_equal(scene.muscles[0].mesh.points, spindle(0)[0])


def test_a_muscle_without_lines_gets_some():
    scene = mw.Scene([mw.Muscle("psoas", *spindle(0))],
                     [mw.Bone("femur", *spindle(22))])
    frame = quick(scene, auto_lines=1).rest_frame
    assert len(frame["psoas"].lines) == 1


def test_parts_keep_what_they_were_given():
    line = mw.Line("psoas", [(0, 0, 2), (0, 0, 98)], ["pelvis", "femur"],
                   slides=True)
    attachment = mw.Attachment("femur", [(0, 0, 98)], 8, may_penetrate=True)
    part = mw.Muscle("psoas", *spindle(0), lines=[line],
                     attachments=[attachment], ends_on=["tendon"])
    assert part.lines[0].bodies == ["pelvis", "femur"]
    assert part.lines[0].slides
    np.testing.assert_array_equal(part.lines[0].points, line.points)
    assert part.attachments[0].radius == 8
    assert part.attachments[0].may_penetrate
    assert part.ends_on == ["tendon"]
    assert mw.Muscle("iliacus", *spindle(0)).ends_on is None
    bone = mw.Bone("femur_r", *spindle(0), body="femur")
    assert (bone.name, bone.body) == ("femur_r", "femur")
    pose = mw.Pose("bent", time=0.5, bodies={"femur": np.eye(4)},
                   lines={"psoas": [(0, 0, 2), (0, 0, 90)]},
                   coordinates={"hip_flexion_r": 30})
    assert pose.time == 0.5 and pose.coordinates == {"hip_flexion_r": 30}
    np.testing.assert_array_equal(pose.bodies["femur"], np.eye(4))
    np.testing.assert_array_equal(pose.lines["psoas"][1], (0, 0, 90))


@pytest.mark.parametrize("make, words", [
    (lambda: mw.Attachment("femur", [(0, 0, 0)], 0), "radius.*is 0"),
    (lambda: mw.Attachment("femur", [(0, 0, 0)], float("nan")), "radius"),
    (lambda: mw.Pose("bent", time=float("inf")), "time"),
    (lambda: mw.Pose("bent", lines={"psoas": [0, 0, 0]}), 'line "psoas"'),
])
def test_other_parts_are_refused(make, words):
    with pytest.raises(mw.InputError, match=words):
        make()


def test_the_rest_pose_moves_nothing(deformer):
    scene = small_scene()
    frame = deformer.solve_alone(scene.rest_pose())
    np.testing.assert_allclose(frame["femur"].points, spindle(45)[0],
                               atol=1e-12)


def test_half_of_the_way_is_half_of_the_move():
    scene = small_scene()
    pose = scene.pose_between(pushed(2), pushed(6), 0.5)
    assert pose.bodies["femur"][0, 3] == pytest.approx(-4, abs=1e-12)
    with pytest.raises(mw.InputError, match="part: is 2"):
        scene.pose_between(pushed(2), pushed(6), 2)


def test_poses_are_listed_by_name():
    assert repr(pushed(5)) == '<musclewarp.Pose "pushed by 5">'
    assert "2 muscles, 1 bones" in repr(small_scene())
    assert mw.Scene([muscle("psoas", 0)]).muscles[0].name == "psoas"


def test_the_demo_scene_may_be_kept(tmp_path):
    scene = mw.demo_scene(tmp_path)
    assert scene.path == str(tmp_path / "scene/motion.json")
    assert (tmp_path / "scene/hip.osim").read_bytes() == (
        DEMO.parent / "hip.osim").read_bytes()
    inside = mw.demo_scene()
    assert len(inside.poses) == 15
    for file, memory in zip(scene.muscles + scene.bones,
                            inside.muscles + inside.bones):
        np.testing.assert_array_equal(memory.mesh.points, file.mesh.points)
    (tmp_path / "file").touch()
    with pytest.raises(mw.InputError, match="file/scene"):
        mw.demo_scene(tmp_path / "file")
