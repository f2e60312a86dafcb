# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Frames: what they show, and how long."""
import gc

import numpy as np
import pytest

import musclewarp as mw
from conftest import pushed, quick


def test_shows_points_and_triangles_without_copies(deformer):
    frame = deformer.solve_alone(pushed(5))
    psoas = frame["psoas"]
    assert psoas.points.shape == (134, 3)
    assert psoas.points.dtype == np.float64
    assert psoas.triangles.shape == (264, 3)
    assert psoas.triangles.dtype == np.int32
    assert psoas.gaps.shape == (134,)
    assert np.shares_memory(frame["psoas"].points, psoas.points)
    assert not psoas.points.flags.writeable
    assert not psoas.points.flags.owndata


def test_arrays_outlive_their_frame_and_frames_their_deformer():
    deformer = quick()
    frame = deformer.solve_alone(pushed(5))
    points, triangles = frame["psoas"].points, frame["femur"].triangles
    expected = points.copy(), triangles.copy()
    report = str(frame)
    del deformer
    gc.collect()
    assert str(frame) == report
    psoas = frame["psoas"]
    del frame
    gc.collect()
    np.testing.assert_array_equal(psoas.points, expected[0])
    del psoas
    gc.collect()
    # Memory that was let go would be used again.
    rubble = [np.random.rand(134, 3) for _ in range(1000)]
    np.testing.assert_array_equal(points, expected[0])
    np.testing.assert_array_equal(triangles, expected[1])
    assert len(rubble) == 1000


def test_knows_volumes_and_lengths_at_rest(deformer):
    for muscle in deformer.rest_frame.muscles:
        assert muscle.volume == pytest.approx(
            mw.Mesh(muscle.points, muscle.triangles).volume, rel=1e-12)
        assert all(length > 0 for length in muscle.line_lengths.values())
        assert len(muscle.line_lengths) == len(muscle.lines)


def test_is_a_collection_of_its_parts(deformer):
    frame = deformer.rest_frame
    assert list(frame) == frame.names == ["psoas", "iliacus", "femur"]
    assert len(frame) == 3
    assert [muscle.name for muscle in frame.muscles] == ["psoas", "iliacus"]
    assert [bone.name for bone in frame.bones] == ["femur"]
    assert "femur" in frame and "tibia" not in frame
    with pytest.raises(KeyError, match="tibia.*psoas, iliacus, femur"):
        frame["tibia"]


def test_says_what_is_known(deformer):
    frame = deformer.solve_alone(pushed(10))
    assert frame.usable and frame.shortcomings == []
    assert frame.stop_reason == "converged"
    assert frame.intersections["triangle_pairs"] == 0
    iliacus = frame["iliacus"]
    assert iliacus.volume == pytest.approx(
        mw.Mesh(iliacus.points, iliacus.triangles).volume, rel=1e-12)
    assert iliacus.volume_ratio == pytest.approx(1, abs=2e-8)
    assert iliacus.shape["max_stretch"] > 1
    assert iliacus.gaps.min() >= 0.1
    assert iliacus.stop_reason == "converged"
    assert "iliacus" in str(frame)
    assert repr(frame).startswith("<musclewarp.Frame pushed by 10: usable")


def test_lines_and_fibres_are_arrays():
    frame = quick(fibres=5).solve_alone(pushed(5))
    for line in frame["psoas"].lines + frame["psoas"].fibres:
        assert line.ndim == 2 and line.shape[1] == 3
    assert len(frame["psoas"].lines) == 1
    assert len(frame["psoas"].fibres) == 5


def test_frames_that_are_not_usable_say_why():
    # Without contact the bone is 4 mm deep in the muscle.
    frame = quick(contact="none").solve_alone(pushed(10))
    assert frame.crossing_pairs > 0
    assert frame.intersections["max_depth_mm"] > 1
    assert len(frame.intersections["pairs"]) == 2
    for pair in frame.intersections["pairs"]:
        found = mw.crossings(frame[pair["a"]], frame[pair["b"]])
        assert len(found.triangle_pairs) == pair["triangle_pairs"]


def test_becomes_polydata_of_vtk(deformer):
    pytest.importorskip("vtkmodules.vtkCommonDataModel")
    from vtkmodules.util.numpy_support import vtk_to_numpy
    frame = deformer.solve_alone(pushed(5))
    meshes = frame.polydata()
    assert list(meshes) == frame.names
    points, triangles = frame["psoas"].points, frame["psoas"].triangles
    psoas = frame["psoas"].polydata()
    del frame
    gc.collect()
    np.testing.assert_array_equal(vtk_to_numpy(psoas.GetPoints().GetData()),
                                  points)
    np.testing.assert_array_equal(
        vtk_to_numpy(psoas.GetPolys().GetConnectivityArray()).reshape(-1, 3),
        triangles)
    assert psoas.GetPointData().GetArray("gap").GetNumberOfTuples() == 134
