# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Moment arms of the fibres as the fine meshes carry them.

A run carries its fibres by the hull of their muscle, of some 200 vertices, and
its moment arms are derivatives of that hull. Here the same fibres are tied to
the fine mesh instead, by mean value coordinates (Ju, Schaefer and Warren 2005)
in its rest shape. The mesh of each frame then carries them, and differences of
their lengths give the moment arms.
"""

import dataclasses

import numpy as np

from bands import Published
from literature import TARGETS, percent
from table import Row, Section, commands, mark, number, paragraphs, plain, prose, table

MEAN_DIFFERENCE = 2.0  # mm
BLOCK = 8  # points whose coordinates are found at a time; few fit the cache
# Seen from a point, three corners span a height: the determinant of their
# directions over the largest cross product of two. Below this the point lies on
# the triangle, or sees it edge on, and then it has no weight.
FLAT = 1e-10
ON_FACE = 1e-5  # how far the angles of the edges then are from a full turn
ON_VERTEX = 1e-14  # of the size of the mesh

ABOUT = f"""
A run carries its fibres by the hull of their muscle, of some 200 vertices, and
its moment arms are exact derivatives of that hull. What contact moves on the
fine mesh alone has no part in them. So that this can be judged, the same fibres
are carried by the fine mesh here: each of their points has mean value
coordinates (Ju, Schaefer and Warren 2005, doi 10.1145/1073204.1073229) in the
mesh at rest, and they give its place from the mesh of each frame. A moment arm
is minus the derivative of the length by the coordinate, by central differences
over neighbouring frames; the first and the last frame have differences of one
side. The lengths of the run are differenced in the same way: the columns
"fine mesh, hull" compare arms of both, over all fibres and frames, and their
mean has a target of at most {MEAN_DIFFERENCE:g} mm. As a check, the columns
"hull, exact" compare the differences with the exact arms of the run, without
the first and the last frame.
"""

ABOUT_SCORES = """
Over hip flexion, bands of these arms cover the published ones so far, scored as
in section {}. Targets are those of the fibres there.
"""


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return np.stack(
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    )


def edges_of(triangles):
    """The edges of a mesh (2 x edges), from the lower vertex to the higher; for
    each triangle the numbers of those from corner k to corner k + 1 (3 x
    triangles), and their signs: -1 where an edge runs backwards."""
    start, end = triangles.T, np.roll(triangles.T, -1, axis=0)
    pairs = np.stack([np.minimum(start, end), np.maximum(start, end)])
    edges, which = np.unique(pairs.reshape(2, -1), axis=1, return_inverse=True)
    return edges, which.reshape(start.shape), np.where(start < end, 1.0, -1.0)


class MeanValues:
    """Mean value coordinates in a closed mesh."""

    def __init__(self, points, triangles):
        self.points, self.triangles = points, triangles
        self.edges, self.edge_of, self.signs = edges_of(triangles)
        self.size = np.linalg.norm(np.ptp(points, axis=0))

    def coordinates(self, queries):
        """The coordinates of points: queries x vertices. Rows sum to 1."""
        rows = np.empty((len(queries), len(self.points)))
        for start in range(0, len(queries), BLOCK):
            part = slice(start, start + BLOCK)
            rows[part] = self._weights(queries[part])
        return rows / rows.sum(axis=1, keepdims=True)

    def _weights(self, queries):
        """The weights of some points, of which no sum is 1."""
        to_vertex = self.points.T[:, None] - queries.T[:, :, None]
        distances = np.sqrt(dot(to_vertex, to_vertex))
        with np.errstate(divide="ignore", invalid="ignore"):
            directions = to_vertex / distances
            weights, on_face = self._face_weights(directions, distances)
        for query, face in np.argwhere(on_face):
            weights[query] = self._barycentric(queries[query], face)
        for query, vertex in np.argwhere(distances <= ON_VERTEX * self.size):
            weights[query] = np.arange(len(self.points)) == vertex
        return weights

    def _face_weights(self, directions, distances):
        """What the triangles add to the weights of their corners, and which
        points lie on which triangles. The mean vector m of a spherical triangle
        is half the sum of the angles of its edges times the unit normals of the
        planes of edge and point; it is a combination of the directions to the
        corners, whose factors are the weights."""
        first, second = (directions[:, :, ends] for ends in self.edges)
        normal = cross(first, second)
        sine = np.sqrt(dot(normal, normal))
        angle = np.arctan2(sine, dot(first, second))
        turn = np.where(sine > 0, angle / sine, 0) * normal
        mean = sum(
            sign / 2 * turn[:, :, edge]
            for sign, edge in zip(self.signs, self.edge_of)
        )
        # Of the edge opposite to corner k, which runs from corner k + 1.
        opposite = [
            self.signs[k] * normal[:, :, self.edge_of[k]] for k in (1, 2, 0)
        ]
        determinant = dot(directions[:, :, self.triangles[:, 0]], opposite[0])
        largest = np.max([sine[:, edge] for edge in self.edge_of], axis=0)
        flat = ~(np.abs(determinant) > FLAT * largest)
        around = sum(angle[:, edge] for edge in self.edge_of)
        weights = np.empty(distances.shape)
        shares = np.empty((3, *flat.shape))
        for k in range(3):
            d = distances[:, self.triangles[:, k]]
            shares[k] = np.where(flat, 0, dot(opposite[k], mean) / (determinant * d))
        corners = self.triangles.T.ravel()
        for row, of_query in zip(weights, shares.transpose(1, 0, 2)):
            row[:] = np.bincount(corners, of_query.ravel(), len(self.points))
        return weights, flat & (around > 2 * np.pi - ON_FACE)

    def _barycentric(self, query, face):
        """The weights of a point on a triangle: of each corner the area of the
        triangle that the point makes with the other two."""
        corners = self.triangles[face]
        sides = self.points[corners] - query
        weights = np.zeros(len(self.points))
        weights[corners] = np.linalg.norm(
            np.cross(np.roll(sides, -1, axis=0), np.roll(sides, -2, axis=0)), axis=1
        )
        return weights


def lengths_of(points, sizes):
    """The lengths of polylines whose points follow each other, of so many
    points each."""
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    steps = np.append(steps, 0)
    ends = np.cumsum(sizes)
    steps[ends - 1] = 0  # from a polyline to the next
    return np.add.reduceat(steps, ends - sizes)


def differenced(lengths, angles):
    """The moment arms (mm/rad) of lengths (frames x fibres) over angles
    (degrees): minus the derivative by differences."""
    return -np.gradient(lengths, np.radians(angles), axis=0)


@dataclasses.dataclass
class Arms:
    """The moment arms of the fibres of a muscle in a run: frames x fibres."""

    fine: np.ndarray  # carried by the fine mesh, differences of lengths
    hull: np.ndarray  # carried by the hull, differences of lengths
    exact: np.ndarray  # carried by the hull, as the run has them


class Carrier:
    """Carries the fibres of muscles by their fine meshes. Runs of a scene often
    have the same rest, of which the coordinates are found once."""

    def __init__(self):
        self.known = {}

    def _coordinates(self, muscle, points, triangles, queries):
        given = (points, triangles, queries)
        known = self.known.get(muscle)
        if known is None or not all(map(np.array_equal, known[0], given)):
            rows = MeanValues(points, triangles).coordinates(queries)
            self.known[muscle] = given, rows
        return self.known[muscle][1]

    def lengths(self, run, muscle):
        """The lengths of the fibres in each frame, mm: frames x fibres; None if
        the mesh was made anew, so that its triangles are not those at rest."""
        points, triangles = run.mesh("rest", muscle)
        fibres = run.fibres("rest")[muscle]
        sizes = np.array([len(fibre) for fibre in fibres])
        rows, lengths = None, []
        for folder in run.frame_folders():
            moved, same = run.mesh(folder, muscle)
            if not np.array_equal(same, triangles):
                return None
            if rows is None:
                queries = np.concatenate(fibres)
                rows = self._coordinates(muscle, points, triangles, queries)
            lengths.append(lengths_of(rows @ moved, sizes))
        return np.array(lengths)

    def arms(self, run, muscle):
        """The Arms of a muscle in a run; None if its mesh was made anew."""
        fine = self.lengths(run, muscle)
        if fine is None:
            return None
        name = f"{muscle}_fibre_"
        hull = run.columns("fibre_lengths.sto", name)
        exact = run.columns("fibre_moment_arms.sto", name, f".{run.moving}")
        return Arms(
            differenced(fine, run.angles), differenced(hull, run.angles), exact
        )


def compared(run, difference, skipped=0):
    """The mean absolute difference of arms (frames x fibres), and the largest
    with where it is; `skipped` frames at either end are left out."""
    size = np.abs(difference[skipped : len(difference) - skipped])
    frame, fibre = np.unravel_index(size.argmax(), size.shape)
    place = f"fibre {fibre + 1}, {run.place(frame + skipped)}"
    return size.mean(), f"{size.max():.1f} ({place})"


def difference_cells(run, muscle, arms):
    """A row of the table of differences, and the mean that has a target."""
    if arms is None:
        return [run.name, plain(muscle), "mesh made anew"] + [""] * 5, None
    mean, largest = compared(run, arms.fine - arms.hull)
    check, worst = compared(run, arms.hull - arms.exact, skipped=1)
    cells = [run.name, plain(muscle), number(mean), f"{MEAN_DIFFERENCE:g}"]
    cells += [mark(bool(mean <= MEAN_DIFFERENCE)), largest, number(check), worst]
    return cells, mean


def mean_row(run, means):
    """The row of the summary of a run: `means` has (mean, muscle)."""
    mean, muscle = max(means)
    return Row(
        f"{run.name}: arms of fibres of the fine mesh and of the hull, mean difference",
        f"at most {MEAN_DIFFERENCE:g} mm",
        f"{number(mean)} mm ({plain(muscle)})",
        bool(mean <= MEAN_DIFFERENCE),
    )


def score_cells(run, muscle, arms, published):
    """A row of the table of scores over hip flexion."""
    cells = [plain(muscle)]
    for kind in (arms.fine, arms.hull, arms.exact):
        band = kind.min(axis=1), kind.max(axis=1)
        score = published.score(muscle, run.angles, *band)
        cells.append(percent(100 * part for part in score))
    return cells + [percent(TARGETS[muscle])]


def fine_section(runs, data, fibres_number):
    """The section: `runs` are the motions, flexion first; section
    `fibres_number` has the fibres of the runs."""
    published = Published(data / "literature/blemker2005_hip_flexion.csv")
    carrier, cells, rows, scored = Carrier(), [], [], []
    for run in runs:
        means = []
        for muscle in run.muscles:
            arms = carrier.arms(run, muscle)
            row, mean = difference_cells(run, muscle, arms)
            cells.append(row)
            if mean is not None:
                means.append((mean, muscle))
            if arms and run is runs[0]:
                scored.append(score_cells(run, muscle, arms, published))
        if means:
            rows.append(mean_row(run, means))
    head = ["run", "muscle", "fine mesh, hull: mean, mm", "target", "met?"]
    head += ["largest, mm", "hull, exact: mean, mm", "largest, mm"]
    score_head = ["muscle", "fine mesh: covered / IoU, %", "hull, differences"]
    score_head += ["hull, exact", "targets"]
    body = paragraphs(
        prose(ABOUT),
        commands([run.command for run in runs]),
        table(head, cells),
        prose(ABOUT_SCORES.format(fibres_number)),
        table(score_head, scored),
    )
    return Section("Fibres carried by the fine meshes", body, rows)
