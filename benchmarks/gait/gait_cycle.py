# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The angles of hip, knee and ankle over a gait cycle, in 100 frames."""

import csv
import dataclasses
import pathlib

TABLE = pathlib.Path(__file__).resolve().with_name("gait_angles.csv")
JOINTS = ("hip", "knee", "ankle")
FRAMES = 100
PERIOD = 1.0  # of the cycle, s

# What the poses of the shared scenes cover, degrees: flexion, ankle dorsiflexion.
RANGES = {"hip": (-10.0, 45.0), "knee": (0.0, 60.0), "ankle": (-40.0, 20.0)}


@dataclasses.dataclass
class Instant:
    """A frame of the cycle."""

    percent: float
    hip: float  # flexion, degrees; so is the next
    knee: float
    ankle: float  # dorsiflexion, degrees


def table_rows(path=TABLE):
    """The rows of the table, every 2 % from 0 to 100."""
    lines = path.read_text(encoding="utf-8").splitlines()
    rows = csv.DictReader(line for line in lines if not line.startswith("#"))
    return [{key: float(value) for key, value in row.items()} for row in rows]


def doubled(values):
    """Values at the rows and midway, without the last row, which begins the next
    cycle. Midway is the cubic through the two rows on either side; the cycle goes
    on before its first row and after its last one."""
    around = [values[-2], *values, values[1]]
    result = []
    for k in range(1, len(values)):
        before, left, right, after = around[k - 1 : k + 3]
        result += [left, (9 * (left + right) - before - after) / 16]
    return result


def limited(values, joint):
    """The values within the range of a joint, and how many were outside."""
    low, high = RANGES[joint]
    inside = [min(max(value, low), high) for value in values]
    return inside, sum(a != b for a, b in zip(values, inside))


def gait_cycle(rows=None):
    """Returns the frames, and the number of limited ones by joint."""
    rows = table_rows() if rows is None else rows
    columns, outside = {}, {}
    for joint in JOINTS:
        values = doubled([row[joint] for row in rows])
        columns[joint], outside[joint] = limited(values, joint)
    count = len(columns["hip"])
    if count != FRAMES:
        raise ValueError(f"{TABLE}: has {len(rows)} rows, not {FRAMES // 2 + 1}")
    frames = [
        Instant(100 * k / count, *(columns[joint][k] for joint in JOINTS))
        for k in range(count)
    ]
    return frames, outside
