# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""What may be given as an array, and what is said of what may not."""
import numpy as np
import pytest

import musclewarp as mw
from conftest import muscle, quick, spindle

POINTS, TRIANGLES = spindle(0)


def refused(function, *words):
    with pytest.raises(mw.InputError) as caught:
        function()
    for word in words:
        assert word in str(caught.value)
    return caught.value


@pytest.mark.parametrize("given", [
    POINTS.tolist(),
    np.asfortranarray(POINTS),
    np.repeat(POINTS, 2, axis=0)[::2],
    np.hstack([POINTS, POINTS])[:, :3],
    POINTS[::-1][::-1],
    POINTS.astype(">f8"),
    POINTS.astype(np.longdouble),
])
def test_any_order_and_type_gives_the_same_points(given):
    mesh = mw.Mesh(given, TRIANGLES)
    assert mesh.points.dtype == np.float64
    assert mesh.points.flags.c_contiguous
    np.testing.assert_array_equal(mesh.points, POINTS)


@pytest.mark.parametrize("kind", [np.int8, np.int16, np.uint64, np.int64])
def test_any_whole_numbers_are_triangles(kind):
    points, triangles = POINTS[:4], np.array(
        [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], dtype=kind)
    mesh = mw.Mesh(points, triangles)
    assert mesh.triangles.dtype == np.int32
    np.testing.assert_array_equal(mesh.triangles, triangles)


def test_whole_numbers_are_points():
    mesh = mw.Mesh(np.arange(9).reshape(3, 3), [(0, 1, 2)])
    np.testing.assert_array_equal(mesh.points, np.arange(9.0).reshape(3, 3))


def test_what_is_given_is_copied_and_may_be_read_only():
    points = POINTS.copy()
    points.flags.writeable = False
    mesh = mw.Mesh(points, TRIANGLES)
    points.flags.writeable = True
    points[:] = 0
    np.testing.assert_array_equal(mesh.points, POINTS)


def test_what_is_returned_is_read_only_and_not_copied():
    mesh = mw.Mesh(POINTS, TRIANGLES)
    assert np.shares_memory(mesh.points, mesh.points)
    with pytest.raises(ValueError):
        mesh.points[0, 0] = 1
    points = mesh.points
    del mesh
    np.testing.assert_array_equal(points, POINTS)


@pytest.mark.parametrize("points, words", [
    (POINTS.T, ["points", "has the shape (3, 134)", "(n, 3)"]),
    (POINTS.ravel(), ["has the shape (402,)"]),
    (POINTS[None], ["has the shape (1, 134, 3)"]),
    (5.0, ["has the shape ()"]),
    (POINTS + 0j, ["has the type complex128", "real numbers"]),
    (POINTS > 0, ["has the type bool"]),
    (POINTS.astype(str), ["has the type <U"]),
    (None, ["has the type object"]),
    ([[1, 2, 3], [1, 2]], ["points", "no array of numbers", "list"]),
])
def test_other_points_are_refused(points, words):
    refused(lambda: mw.Mesh(points, TRIANGLES), *words)


@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 2e7])
def test_points_that_are_nowhere_are_refused(value):
    points = POINTS.copy()
    points[17, 1] = value
    error = refused(lambda: mw.Mesh(points, TRIANGLES), "point 17")
    assert error.where == "mesh: points: point 17"
    assert error.advice == "allowed: -1e7 to 1e7 mm"
    refused(lambda: mw.Line("line", points), 'line "line"', "point 17")


@pytest.mark.parametrize("triangles, words", [
    (TRIANGLES + 1, ["names point 134, the mesh has 134", "0 to 133"]),
    (TRIANGLES - 1, ["names point -1"]),
    (np.full((1, 3), 2**63, dtype=np.uint64), ["triangle 0", "names point"]),
    (np.full((1, 3), 2**32), ["names point 4294967296"]),
    (TRIANGLES.astype(float), ["has the type float64", "whole numbers"]),
    (TRIANGLES.T, ["has the shape (3, 264)", "(m, 3)"]),
    (np.zeros((0, 3), dtype=int), ["triangles: are none"]),
])
def test_other_triangles_are_refused(triangles, words):
    refused(lambda: mw.Mesh(POINTS, triangles), "triangles", *words)


@pytest.mark.parametrize("motion, words", [
    (np.eye(3), ["has the shape (3, 3)", "(4, 4)"]),
    (2 * np.eye(4), ["is not a rigid motion"]),
    (np.diag([-1.0, 1, 1, 1]), ["is not a rigid motion"]),
    (np.full((4, 4), np.nan), ["femur"]),
    (np.eye(4)[::-1], ["is not a rigid motion"]),
])
def test_motions_that_are_not_rigid_are_refused(motion, words):
    refused(lambda: mw.Pose("bent", bodies={"femur": motion}),
            'pose "bent": body "femur"', *words)


def test_a_mesh_is_given_by_arrays_or_by_a_path():
    refused(lambda: mw.Muscle("psoas"), 'muscle "psoas"', "has no mesh")
    refused(lambda: mw.Bone("femur", POINTS, TRIANGLES, path="femur.ply"),
            'bone "femur"', "has arrays and a path")
    refused(lambda: mw.Muscle("psoas", POINTS), "triangles")


def test_empty_meshes_are_refused_when_they_are_used():
    empty = mw.Muscle("psoas", np.zeros((0, 3)), np.zeros((0, 3), dtype=int),
                      lines=[mw.Line("psoas", [(0, 0, 0), (0, 0, 9)])])
    refused(lambda: quick(mw.Scene([empty])), "psoas")


def test_what_is_no_mesh_is_refused():
    refused(lambda: mw.crossings(3, mw.Mesh(POINTS, TRIANGLES)),
            "a: is no mesh, but int")


def test_anything_with_points_and_triangles_is_a_mesh():
    class Mine:
        points, triangles = POINTS, TRIANGLES

    assert not mw.crossings(Mine, mw.Mesh(POINTS + 100, TRIANGLES))
    assert mw.crossings(Mine, muscle("psoas", 0))


def test_input_errors_can_be_taken_apart_and_pickled():
    import copy
    import pickle
    error = refused(lambda: mw.Mesh(POINTS, TRIANGLES + 1))
    assert str(error) == (f"{error.where}: {error.problem}; {error.advice}")
    assert isinstance(error, ValueError)
    for other in (copy.copy(error), pickle.loads(pickle.dumps(error))):
        assert str(other) == str(error)
        assert other.where == error.where
