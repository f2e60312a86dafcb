# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Label images: of files, of nibabel and of arrays, to joints and frames."""
import json
import subprocess
import types

import numpy as np
import pytest

import musclewarp as mw
from conftest import PROGRAMS

SPACING = 2.0  # mm
HEAD = np.array([0.0, 0.0, 400.0])  # the centre of the hip, mm
NAMES = {1: "femur_r", 2: "hip_right",
         3: {"name": "vastus", "kind": "muscle", "origin": "hip_right",
             "insertion": "femur_r"}}
AFFINE = np.diag([SPACING, SPACING, SPACING, 1.0])
AFFINE[:3, 3] = (-50, -50, 0)


def label_array():
    """A ball on a shaft (1), in a cup (2), and a spindle beside them (3)."""
    i, j, k = np.mgrid[0:51, 0:51, 0:226]
    x, y, z = (axis * SPACING + origin
               for axis, origin in zip((i, j, k), AFFINE[:3, 3]))
    from_head = np.sqrt(x**2 + y**2 + (z - HEAD[2])**2)
    shaft = (x**2 + y**2 < 14**2) & (z > 20) & (z < 385)
    labels = np.zeros(x.shape, np.uint8)
    labels[((x - 34) / 9)**2 + (y / 9)**2 + ((z - 365) / 62)**2 < 1] = 3
    labels[(from_head > 26) & (from_head < 40) & (z > HEAD[2])] = 2
    labels[shaft | (from_head < 23)] = 1
    return labels


ARRAY = label_array()


@pytest.fixture(scope="module")
def labels():
    return mw.read_labels(ARRAY, affine=AFFINE, space="LPS", names=NAMES)


def write_nrrd(path, array):
    """A label image in LPS with the affine of the array."""
    directions = " ".join(f"({','.join(str(v) for v in column)})"
                          for column in AFFINE[:3, :3].T)
    header = ("NRRD0004\ntype: uint8\ndimension: 3\n"
              "space: left-posterior-superior\n"
              f"sizes: {' '.join(map(str, array.shape))}\n"
              f"space directions: {directions}\n"
              f"space origin: ({','.join(map(str, AFFINE[:3, 3]))})\n"
              "encoding: raw\n\n")
    path.write_bytes(header.encode() + array.tobytes("F"))


def test_an_array_becomes_joints_and_a_certified_frame(labels):
    assert sorted(labels.bones) == ["femur_r", "hip_right"]
    assert labels.axes == "LPS"
    leg = mw.articulate(labels)
    (hip,) = leg.joints
    assert hip.name == "hip_r" and hip.quality != "failed", hip.reasons
    # Half a voxel.
    assert np.linalg.norm(hip.center - HEAD) < SPACING / 2
    scene = leg.scene(motion={"hip_flexion_r": (0, 10)}, frames=2)
    assert scene.muscles[0].end_bodies == ["pelvis", "femur_r"]
    deformer = mw.Deformer(scene, coarse_vertices=60)
    frame = deformer.move_to(scene.poses[-1])
    assert frame.usable, frame.shortcomings
    assert frame.crossing_pairs == 0


def test_volumes_are_those_of_the_voxels(labels):
    for label, name in enumerate(("femur_r", "hip_right", "vastus"), start=1):
        voxels = np.count_nonzero(ARRAY == label)
        assert labels.volumes[name] == pytest.approx(voxels * SPACING**3)
    # The surface holds what its voxels hold.
    assert labels.bones["femur_r"].volume == pytest.approx(
        labels.volumes["femur_r"], rel=0.01)


def test_files_images_and_arrays_give_the_same_bits(tmp_path, labels):
    write_nrrd(tmp_path / "seg.nrrd", ARRAY)
    table = tmp_path / "labels.csv"
    table.write_text("label,name,kind,origin,insertion\n1,femur_r\n"
                     "2,hip_right\n3,vastus,muscle,hip_right,femur_r\n")
    turn = np.diag([-1.0, -1.0, 1.0, 1.0])  # from LPS to RAS, and back
    image = types.SimpleNamespace(dataobj=ARRAY.astype(float),
                                  affine=turn @ AFFINE)
    for other in (mw.read_labels(tmp_path / "seg.nrrd", table),
                  mw.read_labels(tmp_path / "seg.nrrd", names=NAMES),
                  mw.read_labels(image, names=NAMES),
                  mw.read_labels(np.asfortranarray(ARRAY), table,
                                 affine=AFFINE, space="LPS")):
        for name, mesh in labels.bones.items():
            assert np.array_equal(other.bones[name].points, mesh.points), name
        assert np.array_equal(other.muscles["vastus"].mesh.points,
                              labels.muscles["vastus"].mesh.points)


def test_joints_are_those_of_the_program(tmp_path, labels):
    write_nrrd(tmp_path / "seg.nrrd", ARRAY)
    (tmp_path / "labels.csv").write_text(
        "label,name\n1,femur_r\n2,hip_right\n3,vastus\n")
    out = tmp_path / "out"
    subprocess.run([PROGRAMS / "musclewarp-articulate", f"--out={out}",
                    f"--labels={tmp_path / 'labels.csv'}",
                    tmp_path / "seg.nrrd"], check=True, capture_output=True)
    written = json.loads((out / "joints.json").read_text(encoding="utf-8"))
    found = mw.articulate(labels).report()
    assert found["joints"] == written["joints"]
    scene = json.loads((out / "scene.json").read_text(encoding="utf-8"))
    (muscle,) = scene["muscles"]
    assert muscle["delivered_volume_mm3"] == labels.volumes["vastus"]


def test_labels_are_separated(labels):
    frame = mw.separate(labels, max_loss=0.2)
    assert frame.usable, frame.shortcomings
    assert [muscle.name for muscle in frame.muscles] == ["vastus"]
    lossless = mw.separate(labels, max_loss=0)
    assert lossless.usable == (
        frame["vastus"].volume_ratio >= 1), lossless.shortcomings


def test_a_bone_may_be_named(labels):
    nailed = mw.read_labels(ARRAY, affine=AFFINE, space="LPS",
                            names={1: "femur_r", 2: "nail"}, bone=["nail"])
    assert sorted(nailed.bones) == ["femur_r", "nail"]
    assert any("3" in note for note in nailed.notes)  # left out


@pytest.mark.parametrize("arguments, words", [
    ({"affine": None}, "affine: is missing"),
    ({"affine": np.eye(3)}, "affine: has the shape"),
    ({"affine": np.zeros((4, 4))}, "affine: has the last row"),
    ({"affine": np.diag([0, 1, 1, 1])}, "image: "),
    ({"image": ARRAY[0]}, r"image: is an array of uint8 and shape \(51, 226\)"),
    ({"image": ARRAY - 1.5}, "image: has values from -1.5"),
    ({"image": ARRAY * 0.5}, "image: has values that are no whole numbers"),
    ({"image": ARRAY * 0}, "image: has no label above 0"),
    ({"space": "LAS"}, "space: is 'LAS'"),
    ({"names": {0: "femur"}}, "names: label 0: is no label"),
    ({"names": {"femur": 1}}, "names: has the label 'femur'"),
    ({"names": {1: "a", 2: "a"}}, "names: label 2: has the name"),
    ({"names": {1: {"name": "a", "colour": "red"}}}, 'has "colour"'),
    ({"names": {1: {"name": "a", "kind": "tooth"}}}, 'has the kind "tooth"'),
    ({"names": {9: "spleen"}}, "names: has none of the labels"),
    ({"names": {1: "a"}, "table": "labels.csv"}, "names: are given beside"),
    ({"edge": 101}, "edge: is 101; allowed: 0 to 100, mm"),
    ({"edge": "long"}, "edge: is 'long'; allowed: a number"),
    ({"pieces": "some"}, "pieces=some.*allowed: largest, all"),
    ({"bone": "tibia"}, 'bone: has "tibia", which is no label'),
    ({"image": "seg.png", "affine": None}, "seg.png"),
    ({"image": "none.nii", "affine": None}, "none.nii"),
    ({"image": "none.nii"}, "affine: is given with a file"),
])
def test_bad_input_is_refused_by_name(arguments, words):
    given = {"image": ARRAY, "affine": AFFINE, "names": NAMES, **arguments}
    with pytest.raises(mw.InputError, match=words):
        mw.read_labels(**given)
