#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Says what two builds did to the shapes of muscles, by scene.

  scripts/compare_builds.py --before=DIR --after=DIR --data_root=DATA --out=OUT
  scripts/compare_shapes.py OUT

Every cell has the figure before and after: usable frames; the mean over
muscles and frames, and the largest, of how far contact moved a point (mm); the
smallest gap (mm); the largest stretch at a vertex; the 99.9 % quantile of the
stretch of triangles in the worst muscle and frame, and the largest patch that
is stretched beyond 2 (cm2), where both builds measure them; folded triangles;
the largest mean drift of an attachment area (mm); steps.
"""
import json
import pathlib
import statistics
import sys


def muscles_of(report):
    return [muscle for frame in report["frames"] for muscle in frame["muscles"]]


def largest(report, value):
    return max(value(muscle) for muscle in muscles_of(report))


def triangles(muscle):
    return muscle["shape"]["triangle_stretch"]


def usable(report):
    count = sum(frame["usable"] for frame in report["frames"])
    return f"{count}/{len(report['frames'])}"


def drift(muscle):
    return max((area["mean_drift_mm"] for area in muscle["attachments"]),
               default=0)


COLUMNS = {
    "usable": usable,
    "moved, mean": lambda report: "%.2f" % statistics.mean(
        muscle["mean_contact_displacement_mm"]
        for muscle in muscles_of(report)),
    "moved, largest": lambda report: "%.1f" % largest(
        report, lambda muscle: muscle["max_contact_displacement_mm"]),
    "gap": lambda report: "%.3f" % min(
        frame["smallest_gap_mm"] for frame in report["frames"]),
    "stretch": lambda report: "%.2f" % largest(
        report, lambda muscle: muscle["shape"]["max_stretch"]),
    "99.9 %": lambda report: "%.2f" % largest(
        report, lambda muscle: triangles(muscle)["quantile_999"]),
    "patch": lambda report: "%.2f" % (largest(
        report, lambda muscle: triangles(muscle)["largest_patch_mm2"]) / 100),
    "folded": lambda report: str(sum(
        muscle["folded_triangles"] for muscle in muscles_of(report))),
    "drift": lambda report: "%.2f" % largest(report, drift),
    "steps": lambda report: str(sum(
        frame["pose_steps"] for frame in report["frames"])),
}


def cell(reports, figure):
    texts = []
    for report in reports:
        try:
            texts.append(figure(report))
        except KeyError:  # a build that did not measure it
            texts.append("-")
    return ", ".join(texts)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    out = pathlib.Path(sys.argv[1])
    print("| scene | " + " | ".join(COLUMNS) + " |")
    print("|---" * (len(COLUMNS) + 1) + "|")
    for before in sorted(out.glob("before/*/report.json")):
        after = out / "after" / before.relative_to(out / "before")
        if not after.exists():
            continue
        reports = [json.loads(file.read_text()) for file in (before, after)]
        if reports[0]["contact"] != "certified":
            continue
        cells = [cell(reports, figure) for figure in COLUMNS.values()]
        print(f"| {before.parent.name} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
