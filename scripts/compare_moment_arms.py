#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
r"""Compares moment arms of straight paths with those that OpenSim computed.

  scripts/compare_moment_arms.py motion TABLE COORDINATE OUT.mot
  scripts/compare_moment_arms.py compare TABLE COORDINATE RUN/moment_arms.sto
  scripts/compare_moment_arms.py lengths RUN/lengths.sto COORDINATE \
      RUN/moment_arms.sto [--step=2]
  scripts/compare_moment_arms.py carried RUN/lengths.sto COORDINATE \
      RUN/moment_arms.sto [--step=2]

TABLE is a plot of moment arms (m) that the OpenSim GUI saved: a column for the
coordinate in degrees and one for each muscle. `motion` writes a motion with one
row for each angle of TABLE, for musclewarp-deform to run. `compare` prints, for
each muscle, the largest difference from TABLE (mm) and where it is. Rows beyond
--to degrees are left out of both. `lengths` compares the moment arms of a run,
whose frames are --step degrees apart, with the slopes of its own lengths.
`carried` does so for the lines or fibres that muscles carry, with slopes of
polynomials through five frames.
"""

import argparse
import math
import sys


def read_table(path):
    """Returns the column labels and the rows of a .mot or .sto file."""
    with open(path, encoding="utf-8") as file:
        lines = [line.strip() for line in file]
    start = lines.index("endheader") + 1
    rows = [[float(v) for v in line.split()] for line in lines[start + 1 :] if line]
    return lines[start].split("\t"), rows


def rows_of(path, coordinate, limit):
    labels, rows = read_table(path)
    if coordinate not in labels:
        sys.exit(f"{path}: no column {coordinate}; it has {', '.join(labels)}")
    column = labels.index(coordinate)
    return labels, column, [row for row in rows if row[column] <= limit]


def write_motion(args):
    _, column, rows = rows_of(args.table, args.coordinate, args.to)
    with open(args.file, "w", encoding="utf-8") as file:
        file.write(f"{args.coordinate}\nversion=1\nnRows={len(rows)}\nnColumns=2\n")
        file.write(f"inDegrees=yes\nendheader\ntime\t{args.coordinate}\n")
        for index, row in enumerate(rows):
            file.write(f"{index / 100:.2f}\t{row[column]:.8f}\n")


def compare(args):
    labels, column, expected = rows_of(args.table, args.coordinate, args.to)
    ours, arms = read_table(args.file)
    if len(arms) != len(expected):
        sys.exit(f"{args.file}: {len(arms)} rows; {args.table} has {len(expected)}")
    print(f"{len(arms)} angles, largest difference in mm, where (degrees)")
    for muscle in labels[column + 1 :]:
        k = ours.index(f"{muscle}_path.{args.coordinate}")
        differences = [
            (1e3 * abs(row[k] - reference[labels.index(muscle)]), reference[column])
            for row, reference in zip(arms, expected)
        ]
        largest, angle = max(differences)
        print(f"{muscle:12} {largest:.1e}  {angle:.2f}")


def compare_with_lengths(args):
    lines, lengths = read_table(args.table)
    ours, arms = read_table(args.file)
    print("largest differences of a slope in mm a degree, after which row")
    for name in lines[1:]:
        if not name.endswith("_path"):
            continue
        j, k = lines.index(name), ours.index(f"{name}.{args.coordinate}")
        differences = []
        for row in range(len(lengths) - 1):
            slope = 1e3 * (lengths[row + 1][j] - lengths[row][j]) / args.step
            arm = 1e3 * (arms[row][k] + arms[row + 1][k]) / 2
            differences.append((abs(slope + math.radians(arm)), row))
        (second, at_second), (largest, at) = sorted(differences)[-2:]
        print(f"{name[:-5]:12} {largest:.1e} {at}, next {second:.1e} {at_second}")


def compare_carried(args):
    lines, lengths = read_table(args.table)
    ours, arms = read_table(args.file)
    print("differences in mm: median, largest, in which row; range of the arms")
    for name in lines[1:]:
        if name.endswith("_path"):
            continue
        j, k = lines.index(name), ours.index(f"{name}.{args.coordinate}")
        length = [1e3 * row[j] for row in lengths]
        arm = [1e3 * row[k] for row in arms]
        differences = []
        for row in range(2, len(arm) - 2):
            near = 8 * (length[row + 1] - length[row - 1])
            far = length[row + 2] - length[row - 2]
            slope = (near - far) / (12 * math.radians(args.step))
            differences.append((abs(slope + arm[row]), row))
        differences.sort()
        median, (largest, at) = differences[len(differences) // 2][0], differences[-1]
        span = f"{min(arm):.1f} to {max(arm):.1f}"
        print(f"{name:12} {median:.1e} {largest:.1e} {at}; {span}")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("what", choices=["motion", "compare", "lengths", "carried"])
    parser.add_argument("table")
    parser.add_argument("coordinate")
    parser.add_argument("file")
    parser.add_argument("--to", type=float, default=60.0, help="degrees")
    parser.add_argument("--step", type=float, default=2.0, help="degrees")
    args = parser.parse_args()
    tasks = {
        "motion": write_motion,
        "compare": compare,
        "lengths": compare_with_lengths,
        "carried": compare_carried,
    }
    tasks[args.what](args)


if __name__ == "__main__":
    main()
