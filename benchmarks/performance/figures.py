# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Reads the figures that benchmarks/performance.sh keeps in a folder."""

import json
import statistics

TIMES = {  # of a frame, by the key of report.json
    "wall_ms": "moving",
    "certify_ms": "certificate and measures",
    "moment_arms_ms": "moment arms",
}


def reports(folder, pattern):
    """The files of a pattern, read, by the order of their names."""
    files = sorted(folder.glob(pattern + ".json"))
    if not files:
        raise ValueError(f"{folder}: has no {pattern}.json")
    return [json.loads(file.read_text()) for file in files]


def machine_of(folder):
    """The processor and the code of all reports, which has to be one."""
    read = reports(folder, "mode_*") + reports(folder, "muscles_*")
    found = {(report["machine"]["processor"], report["code"]) for report in read}
    if len(found) > 1:
        raise ValueError(f"{folder}: has reports of several builds or machines")
    return found.pop()


def load_of(folder):
    """The share of the processors that other programs took."""
    return reports(folder, "load")[0]["other_programs"]


def steady_frames(report):
    """The frames from 3 on: those before still settle."""
    return [frame for frame in report["frames"] if frame["index"] >= 3]


def median_time(frames, key):
    return statistics.median(frame[key] for frame in frames)
