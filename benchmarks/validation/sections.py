# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Sections across muscles, and their thickness."""

import numpy as np

from slices import Cut

PLACES = 60  # along a line
ENDS = 0.02  # of a line: no section is nearer to its ends


def resampled(line, count=PLACES):
    """Points at equal distances along a polyline."""
    steps = np.linalg.norm(np.diff(line, axis=0), axis=1)
    along = np.concatenate([[0], np.cumsum(steps)])
    wanted = np.linspace(0, along[-1], count)
    return np.stack([np.interp(wanted, along, axis) for axis in line.T], axis=1)


def length_of(line):
    return np.linalg.norm(np.diff(line, axis=0), axis=1).sum()


def middle_line(lines):
    """The mean of lines that run the same way, smoothed."""
    line = np.mean([resampled(np.asarray(line)) for line in lines], axis=0)
    for _ in range(PLACES // 4):
        line[1:-1] = (line[:-2] + 2 * line[1:-1] + line[2:]) / 4
    return resampled(line)


def loop_areas(points, triangles, normal, place):
    """The areas, with the centres, of the loops in which a plane cuts a closed
    mesh; that of a hole is negative."""
    heights = (points - place) @ normal
    if heights.min() >= 0 or heights.max() <= 0:
        return np.zeros(0), np.zeros((0, 3))
    cut = Cut(points, triangles, heights, 0)
    extended = cut.extended(points)
    a, b, c = (extended[cut.fans[:, k]] for k in range(3))
    loops = len(extended) - len(points) - len(cut.at)
    loop = cut.fans[:, 2] - (len(extended) - loops)
    pieces = np.cross(b - a, c - a) @ normal / 2
    return np.bincount(loop, pieces, loops), extended[-loops:]


def plane_area(points, triangles, normal, place):
    """The area in which a plane cuts a closed mesh."""
    return loop_areas(points, triangles, normal, place)[0].sum()


def areas_along(points, triangles, line):
    """Sections across a line: how far along it, and the area of the loop that is
    nearest to it, since a plane may cut a bent muscle twice."""
    middle = resampled(line)
    course = np.gradient(middle, axis=0)
    course /= np.linalg.norm(course, axis=1)[:, None]
    along = np.linspace(0, length_of(middle), PLACES)
    inner = (along > ENDS * along[-1]) & (along < (1 - ENDS) * along[-1])
    areas = []
    for place, normal in zip(middle[inner], course[inner]):
        found, centres = loop_areas(points, triangles, normal, place)
        distances = np.linalg.norm(centres - place, axis=1)
        areas.append(found[distances.argmin()] if len(found) else 0)
    return along[inner], np.array(areas)


def peak_of(x, y):
    """Where the largest of y is, on the parabola through its neighbours."""
    k = int(np.argmax(y))
    if k in (0, len(y) - 1):
        return x[k]
    a, b, c = y[k - 1 : k + 2]
    return x[k] + (x[k + 1] - x[k]) * (a - c) / (2 * (a - 2 * b + c) or 1)


def thickness(points, triangles, origin, direction):
    """How much of a ray is inside a closed mesh."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    side, other, offset = b - a, c - a, origin - a
    across = np.cross(direction, other)
    det = np.einsum("ij,ij->i", side, across)
    det = np.where(det == 0, np.inf, det)
    u = np.einsum("ij,ij->i", offset, across) / det
    turned = np.cross(offset, side)
    v = turned @ direction / det
    far = np.einsum("ij,ij->i", other, turned) / det
    hit = (u >= 0) & (v >= 0) & (u + v <= 1) & (far > 0) & np.isfinite(det)
    # Leaving it counts as much as entering it before takes away.
    return -(np.sign(det) * far)[hit].sum()
