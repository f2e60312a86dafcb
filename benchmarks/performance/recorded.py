# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Figures for tests, as benchmarks/performance.sh keeps them, but tiny."""

import json

STAGES = ["solve without contact", "planes of bones", "moment arms"]
MUSCLES = ["psoas_major_r", "iliacus_r"]


def frame(index, ms=10.0, stages=None, steps=1):
    if stages is None:
        stages = {name: ms for name in STAGES}
    return {
        "index": index,
        "wall_ms": 2 * ms,
        "certify_ms": ms,
        "moment_arms_ms": ms,
        "pose_steps": steps,
        "usable": True,
        "stages": [{"name": n, "ms": t, "visits": 1} for n, t in stages.items()],
    }


def report(frames, vertices=(100, 200), code="0.1.0 abc"):
    return {
        "machine": {"processor": "Abacus", "threads": 2},
        "code": code,
        "prepare": {
            "muscles": [{"fine_vertices": number} for number in vertices],
            "bones": [{}],
        },
        "frames": frames,
    }


def solve(ms):
    """What solve_benchmark writes: each muscle takes `ms` with each method."""
    return {
        "benchmarks": [
            {
                "name": f"{muscle}/{what}/real_time",
                "real_time": ms,
                "fine": 100,
                "coarse": 20,
                "volume_ratio": 1,
            }
            for muscle in MUSCLES
            for what in ("reference", "ceres", "arap_10")
        ]
    }


def write(folder, name, content):
    (folder / f"{name}.json").write_text(json.dumps(content))


def write_figures(folder, load=0.01):
    write(folder, "load", {"other_programs": load})
    frames = [frame(index) for index in range(5)]
    for mode in ("none", "paper", "certified", "reference"):
        for threads in (1, 2):
            write(folder, f"mode_{mode}_{threads}_1", report(frames))
    write(folder, "solve_1", solve(5))
    for number in (2, 4, 8):
        # A step takes as many ms as the square of the number of muscles.
        some = [frame(0), frame(1, number**2, steps=2)]
        write(folder, f"muscles_3_{number}", report(some, [100] * number))
        write(folder, f"vertices_3_{number}", report(some, [100 * number]))
