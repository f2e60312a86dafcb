# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Joints on bones: those of the program, models and scenes of them."""
import json
import math
import subprocess

import numpy as np
import pytest

import musclewarp as mw
from conftest import PROGRAMS, quick, spindle

HEAD = (0.0, 0.0, 400.0)  # the centre of the head of the femur, mm


def revolved(profile, steps=48):
    """The mesh of a profile of (radius, z) that turns about the z axis."""
    (_, low), *rings, (_, high) = profile
    angle = 2 * math.pi / steps * np.arange(steps)
    round_z = np.stack([np.cos(angle), np.sin(angle), 0 * angle], 1)
    points = [radius * round_z + (0, 0, z) for radius, z in rings]
    points = np.vstack([*points, [(0, 0, low), (0, 0, high)]])
    v = np.arange(steps)
    after = (v + 1) % steps
    first, last = len(points) - 2, len(points) - 1
    triangles = [np.stack([0 * v + first, after, v], 1)]
    for i in range(len(rings) - 1):
        a, b = i * steps, (i + 1) * steps
        triangles += [np.stack([v + a, after + a, after + b], 1),
                      np.stack([v + a, after + b, v + b], 1)]
    top = (len(rings) - 1) * steps
    triangles.append(np.stack([v + top, after + top, 0 * v + last], 1))
    return mw.Mesh(points, np.vstack(triangles))


def arc(radius, first, last, count):
    """Points of a circle about the head, by the angle from its lower end."""
    return [(radius * math.sin(a), HEAD[2] - radius * math.cos(a))
            for a in np.linspace(first, last, count)]


def bones():
    """A ball on a shaft, in a cup."""
    shaft = [(14, z) for z in np.linspace(0, 380, 64)]
    ball = arc(23, math.asin(14 / 23) + 0.05, math.pi, 24)
    hollow = arc(26, math.pi, math.pi / 2, 24)
    outside = arc(40, math.pi / 2, math.pi, 24)
    femur = revolved([(0, 0), *shaft, *ball])
    cup = revolved([*hollow, *outside])
    return {"femur_r": femur, "hip_right": cup}


BONES = bones()


def vastus():
    points, triangles = spindle(45)
    line = mw.Line("vastus", [(45, 0, 312), (45, 0, 408)],
                   ["femur_r", "pelvis"])
    return mw.Muscle("vastus", points + (0, 0, 310), triangles, lines=[line])


@pytest.fixture(scope="module")
def hip():
    return mw.articulate(BONES, joints=("hip",))


def program(folder, *flags):
    """Runs musclewarp-articulate on the bones, as files."""
    for name, mesh in BONES.items():
        mw.write_mesh(folder / f"{name}.ply", mesh)
    out = folder / "hip"
    done = subprocess.run(
        [PROGRAMS / "musclewarp-articulate", f"--out={out}", *flags,
         *(folder / f"{name}.ply" for name in BONES)],
        capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    return out


def test_the_meshes_are_closed():
    for mesh in BONES.values():
        assert mesh.defects()["clean"] and mesh.volume > 0


def test_finds_a_hip(hip):
    joint, = hip.joints
    assert (joint.name, joint.kind, joint.side) == ("hip_r", "hip", "right")
    assert (joint.parent, joint.child) == ("pelvis", "femur_r")
    assert joint.quality == "good", joint.reasons
    assert not joint.given and joint.reasons == []
    assert joint.center.shape == (3,)
    np.testing.assert_allclose(joint.center, HEAD, atol=0.3)
    for axes in (joint.axes, joint.child_axes):
        np.testing.assert_allclose(axes.T @ axes, np.eye(3), atol=1e-12)
    assert list(joint.coordinates) == ["hip_flexion_r", "hip_adduction_r",
                                       "hip_rotation_r"]
    flexion = joint.coordinates["hip_flexion_r"]
    assert flexion["scan"] == pytest.approx(0, abs=1e-12)
    assert flexion["range"] == pytest.approx((-math.pi / 6, math.pi * 2 / 3))
    assert "hip_r good" in repr(hip) and "hip_r" in repr(joint)


def test_has_the_results_of_the_program(hip, tmp_path):
    out = program(tmp_path, "--joints=hip")
    assert json.loads((out / "joints.json").read_text()) == hip.report()
    hip.model(tmp_path / "own/model.osim", name="hip")
    for file in ("model.osim", "Geometry/femur_r.obj",
                 "Geometry/hip_right.obj"):
        assert (out / file).read_bytes() == (tmp_path / "own" /
                                             file).read_bytes()


def test_is_the_same_whatever_the_threads(hip):
    for threads in (1, 0):
        mw.set_threads(threads)
        assert mw.articulate(BONES, joints=["hip"]).report() == hip.report()


def test_takes_meshes_of_all_forms(hip, tmp_path):
    path = tmp_path / "femur.ply"
    mw.write_mesh(path, BONES["femur_r"])
    cup = BONES["hip_right"]
    for femur in (path, str(path), mw.Bone("femur_r", path=path)):
        other = mw.articulate({"femur_r": femur,
                               "hip_right": (cup.points, cup.triangles)},
                              joints=["hip"])
        assert other.report() == hip.report()


def test_takes_other_units(hip):
    in_metres = {name: (mesh.points / 1000, mesh.triangles)
                 for name, mesh in BONES.items()}
    found = mw.articulate(in_metres, joints=["hip"], units="m")
    np.testing.assert_allclose(found.joints[0].center, hip.joints[0].center,
                               atol=1e-6)
    scene = found.scene({"vastus": (vastus().mesh.points / 1000,
                                    vastus().mesh.triangles)})
    np.testing.assert_allclose(scene.muscles[0].mesh.points,
                               vastus().mesh.points, rtol=1e-12)
    with pytest.raises(mw.InputError, match="units"):
        mw.articulate(BONES, units="inch")


def test_a_muscle_names_the_bodies_of_its_ends(hip):
    mesh = vastus().mesh
    ends = mw.Muscle("vastus", mesh.points, mesh.triangles,
                     end_bodies=["femur_r", "pelvis"])
    assert ends.end_bodies == ["femur_r", "pelvis"]
    lines = quick(hip.scene([ends])).rest_frame["vastus"].lines
    assert len(lines) == 3
    wrong = mw.Muscle("vastus", mesh.points, mesh.triangles,
                      end_bodies=["femur_r", "skull"])
    with pytest.raises(mw.InputError, match="end_bodies.*skull"):
        quick(hip.scene([wrong]))


def test_the_scene_is_that_of_the_program(hip, tmp_path):
    mw.write_mesh(tmp_path / "vastus.ply", vastus().mesh)
    out = program(tmp_path, "--joints=hip", "--motion=hip_flexion_r:-10:60:4",
                  f"--muscles={tmp_path / 'vastus.ply'}")
    there = mw.read_scene(out / "scene.json")
    here = hip.scene({"vastus": vastus().mesh}, {"hip_flexion_r": (-10, 60)},
                     frames=4, name="hip")
    assert (here.name, here.axes, here.side, here.is_motion) == (
        there.name, there.axes, there.side, there.is_motion)
    assert [(b.name, b.body) for b in here.bones] == [
        (b.name, b.body) for b in there.bones]
    for a, b in zip(here.bones + here.muscles, there.bones + there.muscles):
        np.testing.assert_array_equal(a.mesh.points, b.mesh.points)
        np.testing.assert_array_equal(a.mesh.triangles, b.mesh.triangles)
    assert len(here.poses) == len(there.poses) == 4
    for a, b in zip(here.poses, there.poses):
        assert (a.name, a.time, a.coordinates) == (b.name, b.time,
                                                   b.coordinates)
        for body, motion in b.bodies.items():
            np.testing.assert_array_equal(a.bodies[body], motion)


def test_a_deformer_runs_the_scene(hip):
    scene = hip.scene([vastus()], {"hip_flexion_r": (0, 6)}, frames=2)
    assert scene.path == "" and scene.muscles[0].lines[0].name == "vastus"
    deformer = quick(scene)
    first, last = (deformer.move_to(pose) for pose in scene.poses)
    assert first.usable and last.usable, last.shortcomings
    assert last.coordinates["hip_flexion_r"] == pytest.approx(6)
    np.testing.assert_array_equal(last["hip_right"].points,
                                  BONES["hip_right"].points)
    # Flexion turns about the axis that points to the right.
    joint, turn = hip.joints[0], math.radians(6)
    about_right = [(math.cos(turn), -math.sin(turn), 0),
                   (math.sin(turn), math.cos(turn), 0), (0, 0, 1)]
    rotation = joint.axes @ about_right @ joint.axes.T
    np.testing.assert_allclose(
        last["femur_r"].points,
        (BONES["femur_r"].points - joint.center) @ rotation.T + joint.center,
        atol=1e-6)
    # Poses of one's own are in radians.
    pose = scene.pose_of_model({"hip_flexion_r": math.radians(6)})
    np.testing.assert_allclose(pose.bodies["femur_r"],
                               scene.poses[-1].bodies["femur_r"], atol=1e-9)


def test_without_a_motion_the_first_coordinate_moves(hip):
    scene = hip.scene([vastus()])
    assert len(scene.poses) == 15
    assert [pose.coordinates["hip_flexion_r"]
            for pose in (scene.poses[0], scene.poses[-1])] == pytest.approx(
                [0, 30], abs=1e-9)
    assert len(hip.scene([vastus()], {"hip_flexion_r": (5, 5)}, 1).poses) == 1


def test_a_model_can_be_read(hip, tmp_path):
    hip.model(tmp_path / "leg.osim")
    model = mw.read_model(tmp_path / "leg.osim")
    assert model.name == "leg" and model.warnings == []
    frames = model.body_frames({"hip_flexion_r": 0.2})
    center = np.append(hip.joints[0].center, 1)
    np.testing.assert_allclose(frames["femur_r"] @ center, center, atol=1e-9)
    assert mw.read_mesh(tmp_path / "Geometry/femur_r.obj").volume > 0


def test_takes_corrected_joints_back(hip, tmp_path):
    report = hip.report()
    report["joints"][0]["center_mm"] = [1, 2, 3]
    file = tmp_path / "joints.json"
    file.write_text(json.dumps(report))
    for given in (report, file, str(file)):
        joint, = mw.articulate(BONES, joints=["hip"], given=given).joints
        assert joint.given
        np.testing.assert_array_equal(joint.center, (1, 2, 3))
    report["joints"][0]["name"] = "hipp_r"
    with pytest.raises(mw.InputError, match=r"given: joints\[0\].name: is \"hipp_r\""):
        mw.articulate(BONES, given=report)


def test_a_joint_that_failed_says_why():
    femur = BONES["femur_r"]
    far = mw.Mesh(femur.points - (0, 0, 300), femur.triangles)
    found = mw.articulate({**BONES, "femur_r": far}, joints=["hip"])
    joint, = found.joints
    assert joint.quality == "failed" and "two scans" in joint.reasons[0]
    assert joint.center is joint.axes is joint.child_axes is None
    assert joint.coordinates == {}
    with pytest.raises(mw.InputError, match="motion: has nothing to move"):
        found.scene([vastus()])


def tube(start, end, radius):
    """A cylinder from point to point."""
    start, end = np.array(start, float), np.array(end, float)
    length = np.linalg.norm(end - start)
    rims = np.linspace(0, radius, 8)[1:]
    mesh = revolved([(0, 0), *((r, 0) for r in rims),
                     *((radius, z) for z in np.linspace(0, length, 30)[1:-1]),
                     *((r, length) for r in rims[::-1]), (0, length)])
    z = (end - start) / length
    x = np.cross((0, 1, 0), z)
    if np.linalg.norm(x) == 0:
        x = np.array((1, 0, 0))
    x /= np.linalg.norm(x)
    axes = np.stack([x, np.cross(z, x), z], 1)
    return mw.Mesh(mesh.points @ axes.T + start, mesh.triangles)


def right_femur():
    """Tubes and an open ball that cross each other: a head to the left of a knee."""
    ball = revolved([(0, HEAD[2] - 23), *arc(23, 0.05, math.pi, 30)])
    to_neck = np.array((-48, 4, -60)) / math.sqrt(48**2 + 4**2 + 60**2)
    middles = ball.points[ball.triangles].mean(1) - HEAD
    open_ball = mw.Mesh(ball.points,
                        ball.triangles[middles @ to_neck < 0.8 * 23])
    parts = [open_ball, tube((-48, 4, 25), (-48, 4, 340), 14),
             tube((-48, 4, 340), (0, 0, 400), 14)]
    # Both condyles reach farther back from the shaft than it is wide.
    for x in (-48 - 37.5, -48 + 7.5):
        parts.append(tube((x, 18, 5), (x + 30, 18, 5), 20))
    starts = np.cumsum([0] + [len(part.points) for part in parts])
    return mw.Mesh(np.vstack([part.points for part in parts]),
                   np.vstack([part.triangles + start
                              for part, start in zip(parts, starts)]))


def test_refuses_a_mirrored_femur():
    bones = {"femur": right_femur(), "pelvis": BONES["hip_right"]}
    found = mw.articulate(bones, joints=["hip"])
    assert found.joints[0].side == "right"
    assert "femur: a right femur, by its shape" in found.notes
    bones["femur_l"] = bones.pop("femur")
    with pytest.raises(mw.InputError, match="femur_l: has the shape of a right "
                       "femur and is named left.*mirrored"):
        mw.articulate(bones)


def test_names_that_are_not_known_are_noted(hip):
    found = mw.articulate({**BONES, "femmur": BONES["femur_r"]})
    assert any("femmur: not known as a bone" in note and "femur" in note
               for note in found.notes)
    assert hip.notes == []


@pytest.mark.parametrize("bad, match", [
    ({"bones": {}}, "bones: are none"),
    ({"bones": list(BONES.values())}, "bones: is no dict, but list"),
    ({"bones": {"femur_r": 5}}, 'bone "femur_r": is no mesh, but int'),
    ({"bones": {"femur_r": "none.ply"}}, "none.ply"),
    ({"bones": {"femur_r": ([(0, 0, 0)], [(0, 0, 1)])}},
     'bone "femur_r": triangles'),
    ({"bones": {"a/b": BONES["femur_r"]}}, "a/b"),
    ({"bones": {"thing": BONES["femur_r"]}}, "none has its bones among thing"),
    ({"joints": ["hipp"]}, 'joints: has "hipp", which is no joint'),
    ({"joints": ["elbow"]}, "joint elbow: lacks its bones"),
    ({"side": "up"}, "side=up"),
    ({"zero": "now"}, "zero=now"),
    ({"axes": "LLS"}, "axes=LLS"),
    ({"given": "none.json"}, "none.json"),
    ({"given": {}}, "given"),
])
def test_bad_input_is_refused(bad, match):
    with pytest.raises(mw.InputError, match=match):
        mw.articulate(**{"bones": BONES, **bad})


@pytest.mark.parametrize("bad, match", [
    ({"muscles": []}, "muscles: are none"),
    ({"muscles": [vastus(), vastus()]}, 'muscle "vastus": has the name'),
    ({"muscles": {"femur_r": vastus().mesh}}, 'muscle "femur_r"'),
    ({"muscles": {"vastus": 5}}, 'muscle "vastus": has no mesh'),
    ({"motion": {"knee_angle_r": (0, 90)}},
     'motion: has "knee_angle_r", which no joint.*allowed: hip_flexion_r'),
    ({"motion": {"hip_flexion_r": 90}}, "give two numbers"),
    ({"motion": {"hip_flexion_r": (0, math.inf)}}, "allowed: finite"),
    ({"frames": 0}, "frames: is 0"),
])
def test_bad_scenes_are_refused(hip, bad, match):
    with pytest.raises(mw.InputError, match=match):
        hip.scene(**{"muscles": [vastus()], **bad})
