# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Checks of meshes: crossings, separation, repair, files."""
import pathlib
import warnings

import numpy as np
import pytest

import musclewarp as mw
from conftest import spindle

POINTS, TRIANGLES = spindle(0)
MESH = mw.Mesh(POINTS, TRIANGLES)


def beside(x):
    return mw.Mesh(POINTS + (x, 0, 0), TRIANGLES)


def test_meshes_apart_do_not_cross():
    found = mw.crossings(MESH, beside(25))
    assert not found
    assert found.triangle_pairs.shape == (0, 2)
    assert len(found.a_inside_b) == 0
    assert found.a_depth == 0


def test_meshes_that_overlap_cross():
    found = mw.crossings(MESH, beside(15))  # by 5 mm in the middle
    assert found
    assert found.triangle_pairs.dtype == np.int32
    assert found.triangle_pairs.max() < len(TRIANGLES)
    # Points inside are on the side of the other mesh.
    assert (POINTS[found.a_inside_b, 0] > 0).all()
    assert 0 < found.a_depth <= 5
    other = mw.crossings(beside(15), MESH)
    assert len(other.triangle_pairs) == len(found.triangle_pairs)
    np.testing.assert_array_equal(other.b_inside_a, found.a_inside_b)


def test_a_mesh_that_crosses_itself_is_told():
    assert len(mw.self_crossings(MESH)) == 0
    both = mw.Mesh(np.vstack([POINTS, POINTS + (15, 0, 0)]),
                   np.vstack([TRIANGLES, TRIANGLES + len(POINTS)]))
    pairs = mw.self_crossings(both)
    assert len(pairs) == len(mw.crossings(MESH, beside(15)).triangle_pairs)
    assert (pairs[:, 0] < pairs[:, 1]).all()


def test_separates_meshes_and_keeps_their_volume():
    frame = mw.separate({"psoas": MESH, "iliacus": beside(18)}, gap=0.2)
    assert frame.usable, frame.shortcomings
    assert frame.smallest_gap >= 0.2
    assert not mw.crossings(frame["psoas"], frame["iliacus"])
    assert frame["psoas"].volume == pytest.approx(MESH.volume, rel=2e-8)


def test_a_gap_follows_the_size_of_the_body_unless_it_is_given():
    tiny = {name: mw.Mesh(mesh.points / 32, TRIANGLES)
            for name, mesh in (("a", MESH), ("b", beside(18)))}
    frame = mw.separate(tiny)
    assert frame.usable, frame.shortcomings
    assert 0.1 / 64 <= frame.smallest_gap < 0.005
    assert mw.separate(tiny, gap=0.005).smallest_gap >= 0.005
    with pytest.raises(mw.InputError, match="gap: is 0.2 mm, and the body is 1/64"):
        mw.separate(tiny, gap=0.2)


def test_separates_meshes_from_bones_that_stay():
    frame = mw.separate([MESH], bones=[beside(18)])
    assert frame.names == ["mesh_1", "bone_1"]
    assert not mw.crossings(frame["mesh_1"], frame["bone_1"])
    np.testing.assert_array_equal(frame["bone_1"].points, POINTS + (18, 0, 0))


def test_what_cannot_be_separated_is_refused():
    with pytest.raises(mw.InputError, match="meshes: are none"):
        mw.separate([])
    with pytest.raises(mw.InputError, match="gap"):
        mw.separate([MESH], gap=3)
    with pytest.raises(mw.InputError, match="remake=perhaps"):
        mw.separate([MESH], remake="perhaps")
    flat = mw.Mesh(np.zeros((3, 3)), [(0, 1, 2)])
    with pytest.raises(mw.InputError, match="flat: is 0 mm across"):
        mw.separate({"flat": flat})


def test_repair_mends_and_says_what_it_did():
    same, report = mw.repair(MESH)
    np.testing.assert_array_equal(same.points, POINTS)
    assert not any(report.values())
    torn = mw.Mesh(POINTS[TRIANGLES].reshape(-1, 3),
                   np.arange(3 * len(TRIANGLES)).reshape(-1, 3))
    assert not torn.defects()["clean"]
    mended, report = mw.repair(torn)
    assert mended.defects()["clean"]
    assert len(mended.points) == len(POINTS)
    assert report["merged_points"] == 3 * len(TRIANGLES) - len(POINTS)
    assert mended.volume == pytest.approx(MESH.volume, rel=1e-12)


def test_what_cannot_be_repaired_is_refused():
    half = mw.Mesh(POINTS, TRIANGLES[:100])
    with pytest.raises(mw.InputError, match="half"):
        mw.repair(half, name="half")
    with pytest.raises(mw.InputError, match="max_perimeter is -1"):
        mw.repair(MESH, max_hole=-1)


def test_files_keep_all_bits(tmp_path):
    for extension in ("ply", "obj", "off", "vtk"):
        path = str(tmp_path / f"mesh.{extension}")
        mw.write_mesh(path, MESH)
        again = mw.read_mesh(path)
        np.testing.assert_array_equal(again.points, POINTS)
        of_path = mw.read_mesh(pathlib.Path(path))
        np.testing.assert_array_equal(of_path.points, POINTS)
        np.testing.assert_array_equal(again.triangles, TRIANGLES)


def test_what_of_a_file_is_skipped_is_a_warning(tmp_path):
    path = tmp_path / "mesh.stl"
    mw.write_mesh(path, MESH)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mw.read_mesh(path)
    path.write_bytes(path.read_bytes() + b"more")
    with pytest.warns(UserWarning, match="the last 4 bytes were skipped"):
        mw.read_mesh(path)


def test_a_part_of_a_file_is_that_object_alone(tmp_path):
    path = tmp_path / "two.obj"
    mw.write_mesh(path, MESH)
    alone = path.read_text()
    path.write_text(f"o left psoas\n{alone}o other\nf 1 2 3\n")
    part = mw.read_mesh(f"{path}#left psoas")
    np.testing.assert_array_equal(part.points, POINTS)
    np.testing.assert_array_equal(part.triangles, TRIANGLES)
    assert len(mw.read_mesh(pathlib.Path(f"{path}#other")).triangles) == 1
    with pytest.raises(mw.InputError, match="left psoas, other"):
        mw.read_mesh(f"{path}#right psoas")


def test_files_that_are_not_there_are_named(tmp_path):
    with pytest.raises(mw.InputError) as caught:
        mw.read_mesh(str(tmp_path / "missing.ply"))
    assert caught.value.where.endswith("missing.ply")
    with pytest.raises(mw.InputError, match="missing/mesh.ply"):
        mw.write_mesh(str(tmp_path / "missing" / "mesh.ply"), MESH)
    with pytest.raises(mw.InputError, match="mesh.docx"):
        mw.write_mesh(str(tmp_path / "mesh.docx"), MESH)
