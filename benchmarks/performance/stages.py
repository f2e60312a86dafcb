# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The chapter of the stages of a frame, with one thread and with two."""

import statistics

import shared  # noqa: F401, where table is
from figures import TIMES, median_time, reports, steady_frames
from table import prose, table

HEAD = ["stage", "1 thread, ms", "2 threads, ms", "ratio"]


def stage_times(frames):
    """The median of each stage that a frame has, in the order of first visits."""
    times = {}
    for frame in frames:
        for stage in frame["stages"]:
            times.setdefault(stage["name"], []).append(stage["ms"])
    # A frame that does not visit a stage spends no time there.
    return {
        name: statistics.median(seen + [0] * (len(frames) - len(seen)))
        for name, seen in times.items()
    }


def row(name, one, two):
    ratio = f"{one / two:.2f}" if two else ""
    return [name, f"{one:.1f}", f"{two:.1f}", ratio]


def stage_table(one, two):
    """The table of frames with one thread, and of the same with two."""
    times = [stage_times(one), stage_times(two)]
    names = list(times[0]) + [name for name in times[1] if name not in times[0]]
    rows = [row(name, *(seen.get(name, 0) for seen in times)) for name in names]
    for key, name in TIMES.items():
        medians = [median_time(frames, key) for frames in (one, two)]
        rows.append(row(f"**{name}**", *medians))
    return table(HEAD, rows)


def chapter(folder):
    one, two = (reports(folder, f"mode_certified_{n}_*") for n in (1, 2))
    frames = [[f for run in runs for f in steady_frames(run)] for runs in (one, two)]
    muscles, bones = (one[0]["prepare"][part] for part in ("muscles", "bones"))
    vertices = sum(muscle["fine_vertices"] for muscle in muscles)
    last = one[0]["frames"][-1]["index"]
    return [
        f"    musclewarp-deform --scene=data/scenes/lhdl_hip_motion.json "
        f"--data_root=DATA \\\n        --motion=lhdl_hip/motions/hip_flexion.mot "
        f"--frames=0:{last} --profile --threads=N",
        prose(
            f"{len(muscles)} muscles with {vertices} vertices, {len(bones)} bones;",
            f"medians of frames 3 to {last} of all runs, {len(one)} with each number of",
            "threads, by turns. Stages come in the order of the first visit; the last",
            "rows are the times of the report, of which the stages are parts.",
        ),
        stage_table(*frames),
    ]
