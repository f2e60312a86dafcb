# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Reads what musclewarp-deform wrote: the report, tables, lines and meshes."""

import functools
import json
import pathlib

import numpy as np

PLY_HEADER = """ply
format binary_little_endian 1.0
element vertex {}
property double x
property double y
property double z
element face {}
property list uchar int vertex_indices
end_header
"""


def read_table(path):
    """Returns the column labels and the rows (as an array) of a .sto file."""
    lines = [line.strip() for line in path.read_text().splitlines()]
    start = lines.index("endheader") + 1
    rows = [[float(v) for v in line.split()] for line in lines[start + 1 :] if line]
    return lines[start].split("\t"), np.array(rows)


def read_ply(path):
    """Returns the points (n x 3) and the triangles (m x 3) of a mesh file."""
    data = path.read_bytes()
    end = data.find(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode(errors="replace")
    counts = [
        line.split()[-1] for line in header.splitlines() if line.startswith("element")
    ]
    if len(counts) != 2 or header != PLY_HEADER.format(*counts):
        raise ValueError(f"{path}: not a mesh as musclewarp-deform writes it")
    vertices, faces = (int(count) for count in counts)
    points = np.frombuffer(data, "<f8", 3 * vertices, end).reshape(-1, 3)
    face = np.dtype([("size", "u1"), ("corners", "<i4", 3)])
    triangles = np.frombuffer(data, face, faces, end + 24 * vertices)
    return points, triangles["corners"]


class Run:
    """A finished run of musclewarp-deform in a folder."""

    def __init__(self, folder, command):
        self.folder = pathlib.Path(folder)
        self.name = self.folder.name
        self.command = command  # without machine paths, for the page
        report = self.folder / "report.json"
        if not report.exists():
            raise ValueError(f"{self.folder}: no report.json; run without --reuse")
        self.report = json.loads(report.read_text())
        self.frames = self.report["frames"]
        if not self.report["summary"]["finished"]:
            raise ValueError(f"{self.folder}: the run is not finished")

    @functools.cached_property
    def moving(self):
        """The name of the coordinate that the motion moves; None for poses."""
        motion = self.report["motion"] or {"coordinates": []}
        names = [c["name"] for c in motion["coordinates"] if c["moves"]]
        return names[0] if names else None

    @functools.cached_property
    def angles(self):
        """The moving coordinate in degrees, for each frame."""
        return np.array([frame["coordinates"][self.moving] for frame in self.frames])

    def place(self, index):
        """Which frame it is, in words."""
        if self.moving:
            return f"{self.angles[index]:g} degrees"
        return self.frames[index]["name"].replace("_", " ")

    @functools.cached_property
    def muscles(self):
        return [muscle["name"] for muscle in self.report["prepare"]["muscles"]]

    @functools.cache
    def lines_file(self, folder):
        """lines.json of the rest pose or of a frame: muscle by muscle."""
        read = json.loads((self.folder / folder / "lines.json").read_text())
        return {muscle["name"]: muscle for muscle in read["muscles"]}

    @functools.cached_property
    def lines(self):
        """The lines of each muscle at rest: {muscle: {line: points}}."""
        return {
            name: {line["name"]: np.array(line["points"]) for line in muscle["lines"]}
            for name, muscle in self.lines_file("rest").items()
        }

    def fibres(self, folder):
        """The fibres of each muscle at rest or in a frame: {muscle: [points]}."""
        return {
            name: [np.array(points) for points in muscle["fibres"]]
            for name, muscle in self.lines_file(folder).items()
        }

    @functools.cache
    def table(self, name):
        return read_table(self.folder / name)

    def column(self, table, label):
        """A column of a table in millimetres (the files have metres)."""
        labels, rows = self.table(table)
        return 1e3 * rows[:, labels.index(label)]

    def columns(self, table, start, end=""):
        """The columns whose labels start and end so, in mm: frames x columns."""
        labels, rows = self.table(table)
        found = [
            i
            for i, label in enumerate(labels)
            if label.startswith(start) and label.endswith(end)
        ]
        return 1e3 * rows[:, found]

    def mesh(self, folder, muscle):
        return read_ply(self.folder / folder / f"{muscle}.ply")

    def frame_folders(self):
        return [f"frame_{frame['index']:04}" for frame in self.frames]
