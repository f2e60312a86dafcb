# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Volumes of slices along a muscle.

At rest planes across the course of the muscle cut its surface into slices of
equal volume. A cut is one or more loops on the surface. Their points lie at
fixed places on the edges of the mesh and are carried along with it; in every
frame a fan from its centre closes each loop. The slices then have closed
surfaces, and neighbours share the fan between them, so that their volumes add
up to that of the muscle. At rest the loops are plane and the volumes are
those between the planes. Affine maps, rigid motion among them, commute with
the construction.
"""

import numpy as np

SLICES = 10


def volume_of(points, triangles):
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.einsum("ij,ij->", a, np.cross(b, c)) / 6


def course(lines):
    """Returns the direction of a muscle: the sum of the chords of its lines,
    each turned to agree with the longest."""
    chords = np.array([line[-1] - line[0] for line in lines])
    longest = chords[np.argmax(np.linalg.norm(chords, axis=1))]
    chords[chords @ longest < 0] *= -1
    total = chords.sum(axis=0)
    return total / np.linalg.norm(total)


def loops_of(following):
    """Returns for each point of closed loops the number of its loop, where
    `following` has the next point of each."""
    loop = np.full(len(following), -1)
    count = 0
    for start in range(len(following)):
        if loop[start] >= 0:
            continue
        point = start
        while loop[point] < 0:
            loop[point] = count
            point = following[point]
        count += 1
    return loop


class Cut:
    """The part of a closed mesh below a level of a scalar on its vertices,
    closed by fans: `below` are its triangles, `fans` those of the fans, over
    the points of the mesh, of the loops, and the centres of the loops."""

    def __init__(self, points, triangles, heights, level):
        above = heights > level
        number_above = above[triangles].sum(axis=1)
        crossed = triangles[(number_above == 1) | (number_above == 2)]
        # The corner that is alone on its side comes first.
        sides = above[crossed]
        alone = np.argmax(sides == (sides.sum(axis=1) == 1)[:, None], axis=1)
        turned = np.array([[0, 1, 2], [1, 2, 0], [2, 0, 1]])[alone]
        a, b, c = np.take_along_axis(crossed, turned, axis=1).T
        edges = np.sort(np.concatenate([[a, b], [a, c]], axis=1), axis=0)
        self.edges, number = np.unique(edges, axis=1, return_inverse=True)
        i, j = self.edges
        self.at = ((level - heights[i]) / (heights[j] - heights[i]))[:, None]
        p, q = number[: len(a)], number[len(a) :]
        up = above[a]
        # On the boundary of the part below, the loops run from `first` on.
        first, second = np.where(up, q, p), np.where(up, p, q)
        self._set_centres(points, first, second)
        n, m = len(points), len(points) + len(self.at)
        self.fans = np.stack([second + n, first + n, self.loop[first] + m], axis=1)
        p, q = p + n, q + n
        self.below = np.concatenate(
            [
                triangles[number_above == 0],
                np.stack([a, p, q], axis=1)[~up],
                np.stack([p, b, c], axis=1)[up],
                np.stack([p, c, q], axis=1)[up],
            ]
        )

    def _set_centres(self, points, first, second):
        """Sets the weights with which the points of each loop make its centre:
        half the length of the two adjacent pieces at rest, and in the second
        column more of it towards one end, which gives another centre."""
        following = np.empty(len(self.at), int)
        following[first] = second
        self.loop = loops_of(following)
        places = self._places(points)
        length = np.linalg.norm(places[first] - places[second], axis=1)
        weight = np.bincount(first, length) + np.bincount(second, length)
        offsets = places - places.mean(axis=0)
        along = offsets @ np.linalg.svd(offsets, full_matrices=False)[2][0]
        tilted = weight * (1 + 0.5 * along / np.abs(along).max())
        self.weights = np.stack([weight, tilted], axis=1)
        for column in self.weights.T:
            column /= np.bincount(self.loop, column)[self.loop]

    def _places(self, points):
        i, j = self.edges
        return (1 - self.at) * points[i] + self.at * points[j]

    def extended(self, points, column=0):
        """Returns the points over which `below` and `fans` are, with the centres
        of a column of weights."""
        places = self._places(points)
        centres = np.zeros((self.loop.max() + 1, 3))
        np.add.at(centres, self.loop, self.weights[:, column, None] * places)
        return np.concatenate([points, places, centres])

    def volumes(self, points):
        """Returns the volume of the part below, with either set of centres."""
        points = points - points.mean(axis=0)
        closed = np.concatenate([self.below, self.fans])
        return np.array([volume_of(self.extended(points, k), closed) for k in (0, 1)])


class Slices:
    """Slices of a rest mesh, nearly equal in volume, across a direction."""

    def __init__(self, points, triangles, direction, count=SLICES, samples=60):
        self.triangles = triangles
        heights = points @ direction
        inner = np.linspace(heights.min(), heights.max(), samples + 2)[1:-1]
        below = [Cut(points, triangles, heights, h).volumes(points)[0] for h in inner]
        below = [0, *below, self._total(points)]
        levels = np.concatenate([[heights.min()], inner, [heights.max()]])
        wanted = below[-1] * np.arange(1, count) / count
        self.cuts = [
            Cut(points, triangles, heights, level)
            for level in np.interp(wanted, below, levels)
        ]
        self.at_rest = self.volumes(points)

    def _total(self, points):
        return volume_of(points - points.mean(axis=0), self.triangles)

    def volumes(self, points):
        """Returns the volumes with either set of centres: 2 x slices."""
        below = [cut.volumes(points) for cut in self.cuts]
        total = np.full(2, self._total(points))
        return np.diff([np.zeros(2), *below, total], axis=0).T

    def ratios(self, points):
        """Returns the volume of each slice over that at rest: 2 x slices."""
        return self.volumes(points) / self.at_rest


def slice_ratios(run, muscle):
    """Returns the ratios of a muscle over a run (frames x 2 x slices), the
    second set with other centres; None if its mesh was made anew, so that its
    triangles are not those at rest."""
    points, triangles = run.mesh("rest", muscle)
    slices = Slices(points, triangles, course(list(run.lines[muscle].values())))
    ratios = []
    for folder in run.frame_folders():
        moved, same = run.mesh(folder, muscle)
        if not np.array_equal(same, triangles):
            return None
        ratios.append(slices.ratios(moved))
    return np.array(ratios)
