# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Frames are drawn by pyvista, here one that only records what it is asked for;
by the real one where it is installed."""
import importlib.util
import sys
import types

import pytest

import musclewarp as mw
from conftest import pushed


class Plotter:
    def __init__(self, **options):
        self.options, self.meshes, self.shown = options, {}, False

    def add_mesh(self, mesh, name, **look):
        self.meshes[name] = (mesh, look)

    def add_axes(self):
        pass

    def show(self):
        self.shown = True
        return self


@pytest.fixture
def pyvista(monkeypatch):
    pytest.importorskip("vtkmodules.vtkCommonDataModel")
    played = types.ModuleType("pyvista")
    played.Plotter, played.wrap = Plotter, lambda mesh: mesh
    monkeypatch.setitem(sys.modules, "pyvista", played)


@pytest.fixture(scope="module")
def frame(deformer):
    return deformer.solve_alone(pushed(5))


def test_all_parts_are_drawn_and_shown(pyvista, frame):
    plotter = frame.plot(off_screen=True)
    assert plotter.shown and plotter.options == {"off_screen": True}
    assert list(plotter.meshes) == frame.names
    for name, (mesh, look) in plotter.meshes.items():
        assert mesh.GetNumberOfPoints() == len(frame[name].points)
        assert mesh.GetNumberOfCells() == len(frame[name].triangles)
        assert "scalars" not in look
    colors = {name: look["color"] for name, (_, look) in plotter.meshes.items()}
    assert colors["psoas"] == colors["iliacus"] != colors["femur"]


def test_muscles_are_coloured_by_gaps_with_their_unit(pyvista, frame):
    meshes = frame.plot(color_by="gap", show=False).meshes
    for name in ("psoas", "iliacus"):
        mesh, look = meshes[name]
        assert mesh.GetPointData().HasArray(look["scalars"])
        assert look["scalar_bar_args"]["title"].endswith(", mm")
    assert "color" in meshes["femur"][1]


def test_one_part_is_drawn_alone(pyvista, frame):
    for name in ("psoas", "femur"):
        plotter = frame[name].plot(show=False)
        assert list(plotter.meshes) == [name] and not plotter.shown


def test_says_what_to_install(monkeypatch, frame):
    monkeypatch.setitem(sys.modules, "pyvista", None)  # cannot be imported
    with pytest.raises(ImportError, match="pip install pyvista"):
        frame.plot()


def test_an_unknown_colour_is_refused(frame):
    with pytest.raises(mw.InputError, match="'depth'.*\"kind\", \"gap\""):
        frame.plot(color_by="depth")


@pytest.mark.skipif(not importlib.util.find_spec("pyvista"),
                    reason="pyvista is not installed")
def test_pyvista_draws_something(tmp_path, frame):
    plotter = frame.plot(show=False, off_screen=True, window_size=(200, 200))
    picture = plotter.screenshot(str(tmp_path / "frame.png"))
    assert picture.std() > 1  # not of one colour
