#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""What meshio reads in the files of musclewarp-export, and so what FEniCS, sfepy and
pygmsh get, is what was exported: the meshes of the run, and the parts of the .feb of the
same export, which has all of them by name.

usage: MUSCLEWARP_DEFORM=... MUSCLEWARP_EXPORT=... MUSCLEWARP_DATA_DIR=... meshio_test.py

Exits with 77 if meshio or tetgen is not there.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

SKIPPED = 77
FRAME = "frame_0004"

try:
    import meshio
    import numpy
except ImportError as error:
    print(f"skipped: {error}; apt-get install python3-meshio")
    sys.exit(SKIPPED)
if shutil.which("tetgen") is None:
    print("skipped: there is no tetgen; apt-get install tetgen")
    sys.exit(SKIPPED)


def numbers(text, kind):
    return [kind(number) for number in text.split(",")]


class Exported:
    """A frame of the embedded scene, and what its .feb has."""

    def __init__(self, folder):
        run = folder / "run"
        scene = pathlib.Path(os.environ["MUSCLEWARP_DATA_DIR"]) / "phantom/motion.json"
        subprocess.run(
            [os.environ["MUSCLEWARP_DEFORM"], f"--scene={scene}", f"--out={run}", "--frames=4"],
            check=True, stdout=subprocess.DEVNULL)
        self.folder = folder / "elements"
        subprocess.run(
            [os.environ["MUSCLEWARP_EXPORT"], f"--in={run}", f"--out={self.folder}",
             "--format=inp,msh,vtu,feb", "--bone_tolerance=0"],
            check=True, stdout=subprocess.DEVNULL)
        prepare = json.loads((run / "report.json").read_text())["prepare"]
        self.muscles = [muscle["name"] for muscle in prepare["muscles"]]
        self.bones = [bone["name"] for bone in prepare["bones"]]
        self.meshes = {name: meshio.read(run / FRAME / f"{name}.ply")
                       for name in self.muscles + self.bones}
        attachments = json.loads((run / "attachments.json").read_text())
        self.body_of = {bone: attachments["bones"].get(bone, bone) for bone in self.bones}
        self.read_feb()

    def read_feb(self):
        spec = ElementTree.parse(self.folder / f"{FRAME}.feb").getroot()
        mesh = spec.find("Mesh")
        self.points = numpy.array([numbers(node.text, float) for node in mesh.iter("node")])
        self.cells = {part.get("name"): numpy.array([numbers(cell.text, int) for cell in part]) - 1
                      for part in mesh.iter("Elements")}
        self.attachments = {area.get("name"): numpy.array(numbers(area.text, int)) - 1
                            for area in mesh.iter("NodeSet")}
        self.fibres = {data.get("elem_set"): [numbers(cell.find("a").text, float) for cell in data]
                       for data in spec.find("MeshData")}

    def read(self, extension):
        return meshio.read(self.folder / f"{FRAME}.{extension}")

    def tetrahedra(self):
        return sum(len(self.cells[name]) for name in self.muscles)

    def triangles(self, names):
        return sum(len(self.meshes[name].cells_dict["triangle"]) for name in names)

    def number_of_surface_points(self):
        return sum(len(self.meshes[name].points) for name in self.muscles)


def cells_of(mesh, name):
    """The cells of a set by their type, each with the corners in space."""
    return {kind: mesh.points[mesh.cells_dict[kind][which]]
            for kind, which in mesh.cell_sets_dict[name].items()}


class Meshio(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="musclewarp_meshio_")
        cls.exported = Exported(pathlib.Path(cls.temporary.name))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def expect_same(self, a, b):
        # A number of .inp has at most 20 characters, which are 14 digits or more.
        numpy.testing.assert_allclose(a, b, rtol=1e-13, atol=0)

    def expect_muscles(self, mesh):
        """Elements of muscles by name, where they are in the run."""
        wanted = self.exported
        for name in wanted.muscles:
            cells = cells_of(mesh, name)
            self.assertEqual(list(cells), ["tetra"], name)
            self.expect_same(cells["tetra"], wanted.points[wanted.cells[name]])

    def expect_parts(self, mesh):
        """Elements of muscles and bones by name, where they are in the run."""
        self.expect_muscles(mesh)
        wanted = self.exported
        for bone in wanted.bones:
            cells = cells_of(mesh, bone)
            self.assertEqual(list(cells), ["triangle"], bone)
            self.expect_same(cells["triangle"], wanted.points[wanted.cells[bone]])
            self.expect_same(cells["triangle"], self.bone_triangles(bone))

    def bone_triangles(self, bone):
        surface = self.exported.meshes[bone]
        return surface.points[surface.cells_dict["triangle"]]

    def expect_layer(self, tetrahedra, triangles):
        """Elements whose first face is a triangle, seen from inside."""
        self.expect_same(tetrahedra[:, [0, 2, 1]], triangles)

    def test_feb_has_the_meshes_of_the_run(self):
        wanted = self.exported
        self.assertEqual(set(wanted.cells), set(wanted.muscles + wanted.bones))
        self.assertGreater(len(wanted.attachments), 0)
        self.assertEqual(set(wanted.fibres), set(wanted.muscles))
        points = numpy.concatenate([wanted.meshes[name].points for name in wanted.muscles])
        self.expect_same(wanted.points[:len(points)], points)

    def test_inp(self):
        wanted = self.exported
        mesh = wanted.read("inp")
        bodies = set(wanted.body_of.values())
        of_bones = wanted.triangles(wanted.bones)
        self.assertEqual(len(mesh.points), len(wanted.points) + len(bodies) + of_bones)
        self.expect_same(mesh.points[:len(wanted.points)], wanted.points)
        self.assertEqual(len(mesh.cells_dict["tetra"]), wanted.tetrahedra() + of_bones)
        self.assertEqual(
            set(mesh.cell_sets),
            {*wanted.muscles, *wanted.bones, *(f"body_{body}_BONES" for body in bodies)})
        self.expect_muscles(mesh)
        self.assertEqual(
            set(mesh.point_sets),
            {"MUSCLE_NODES", *wanted.attachments, *(f"{bone}_NODES" for bone in wanted.bones),
             *(f"{bone}_INNER_NODES" for bone in wanted.bones),
             *(f"body_{body}" for body in bodies),
             *(f"body_{body}_RIGID" for body in bodies)})
        for name, area in wanted.attachments.items():
            self.expect_same(mesh.point_sets[name], area)
        for bone in wanted.bones:
            self.expect_same(mesh.points[mesh.point_sets[f"{bone}_NODES"]],
                             wanted.meshes[bone].points)
            self.expect_layer(cells_of(mesh, bone)["tetra"], self.bone_triangles(bone))
        for body in bodies:
            of_body = [self.bone_triangles(bone) for bone in wanted.bones
                       if wanted.body_of[bone] == body]
            cells = cells_of(mesh, f"body_{body}_BONES")
            self.assertEqual(list(cells), ["tetra"])
            self.expect_layer(cells["tetra"], numpy.concatenate(of_body))
            self.assertTrue(set(mesh.point_sets[f"body_{body}_RIGID"])
                            >= {node for name, area in wanted.attachments.items()
                                if name.endswith(f"_on_{body}") for node in area})
            self.assertGreaterEqual(mesh.point_sets[f"body_{body}"][0], len(wanted.points))

    def test_msh(self):
        wanted = self.exported
        mesh = wanted.read("msh")
        self.assertEqual(len(mesh.points), len(wanted.points))
        self.assertEqual(len(mesh.cells_dict["tetra"]), wanted.tetrahedra())
        self.assertEqual(len(mesh.cells_dict["triangle"]),
                         wanted.triangles(wanted.muscles + wanted.bones))
        self.expect_parts(mesh)
        dimensions = {name: dimension for name, (_, dimension) in mesh.field_data.items()}
        areas = {name for name in wanted.attachments if name in dimensions}
        self.assertGreater(len(areas), 0)
        self.assertEqual(dimensions, {
            **{name: 3 for name in wanted.muscles},
            **{name: 2 for name in wanted.bones},
            **{f"{name}_surface": 2 for name in wanted.muscles},
            **{name: 2 for name in areas}})
        for name in wanted.muscles:
            surface = wanted.meshes[name]
            expected = surface.points[surface.cells_dict["triangle"]]
            found = cells_of(mesh, f"{name}_surface")["triangle"]
            self.expect_same(sorted(found.tolist()), sorted(expected.tolist()))
        for name in areas:
            attached = {tuple(point) for point in wanted.points[wanted.attachments[name]]}
            corners = cells_of(mesh, name)["triangle"].reshape(-1, 3)
            self.assertLessEqual({tuple(point) for point in corners}, attached)
        fibres = mesh.cell_data_dict["fibre"]
        self.expect_same(fibres["triangle"], 0)
        for name in wanted.muscles:
            of_muscle = fibres["tetra"][mesh.cell_sets_dict[name]["tetra"]]
            self.expect_same(of_muscle, wanted.fibres[name])

    def test_vtu(self):
        wanted = self.exported
        mesh = wanted.read("vtu")
        self.expect_same(mesh.points, wanted.points)
        self.assertEqual({kind: len(cells) for kind, cells in mesh.cells_dict.items()},
                         {"tetra": wanted.tetrahedra(),
                          "triangle": wanted.triangles(wanted.bones)})
        fields = {name: float(value.item()) for name, value in mesh.field_data.items()}
        bodies = [name for name in fields if name.startswith("body_")]
        self.assertEqual(fields.pop("frame"), 4)
        self.assertGreaterEqual(fields.pop("TimeValue"), 0)
        self.assertEqual(set(fields), {
            *(f"muscle_{name}" for name in wanted.muscles),
            *(f"bone_{name}" for name in wanted.bones), *bodies})
        data = mesh.cell_data_dict
        self.assertEqual(set(data), {"muscle", "bone", "fibre"})
        for names, kind, what in [(wanted.muscles, "tetra", "muscle"),
                                  (wanted.bones, "triangle", "bone")]:
            for name in names:
                which = data[what][kind] == fields[f"{what}_{name}"]
                self.expect_same(mesh.cells_dict[kind][which], wanted.cells[name])
                if what == "muscle":
                    self.expect_same(data["fibre"]["tetra"][which], wanted.fibres[name])
        self.expect_same(data["fibre"]["triangle"], 0)
        self.assertEqual(set(mesh.point_data), {"attachment"})
        for body in bodies:
            found = numpy.flatnonzero(mesh.point_data["attachment"] == fields[body])
            of_body = [area for name, area in wanted.attachments.items()
                       if name.endswith("_on_" + body[len("body_"):])]
            self.expect_same(found, numpy.unique(numpy.concatenate(of_body)))


if __name__ == "__main__":
    unittest.main(verbosity=2)
