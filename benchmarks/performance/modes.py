# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The chapter of the modes of contact beside CGAL's deformation."""

import statistics

import shared  # noqa: F401, where table is
from figures import median_time, reports, steady_frames
from table import plain, prose, span, table

MODES = {
    "none": "`--contact=none`",
    "paper": "`--contact=paper`",
    "certified": "`--contact=certified`, Ceres",
    "reference": "`--contact=certified --solver=reference`",
}
ARAP = "arap_10"
SOLVES = {"reference": "reference", "ceres": "Ceres", ARAP: "CGAL"}


def solve_times(solves):
    """Means over the turns of solve_benchmark, by muscle and what is measured."""
    seen = {}
    for solve in solves:
        for item in solve["benchmarks"]:
            muscle, what = item["name"].split("/")[:2]
            seen.setdefault(muscle, {}).setdefault(what, []).append(item)
    return {
        muscle: {
            what: {
                key: statistics.mean(item[key] for item in items)
                for key in ("real_time", "fine", "coarse", "volume_ratio")
            }
            for what, items in by_what.items()
        }
        for muscle, by_what in seen.items()
    }


def cgal_turns(solves):
    """The time of all muscles with CGAL, in each turn."""
    return [
        sum(
            item["real_time"]
            for item in solve["benchmarks"]
            if item["name"].split("/")[1] == ARAP
        )
        for solve in solves
    ]


def cells(turns, cgal):
    """A mean with its span, and its ratio to the time of CGAL."""
    mean = statistics.mean(turns)
    return [f"{mean:.0f} ({span(turns, 0)})", f"{mean / cgal:.2f}"]


def mode_table(times, cgal):
    """`times` has those of the turns by mode and number of threads."""
    head = ["", "1 thread, ms", "ratio to CGAL", "2 threads, ms", "ratio to CGAL"]
    mean = statistics.mean(cgal)
    rows = [
        [name, *cells(times[mode, 1], mean), *cells(times[mode, 2], mean)]
        for mode, name in MODES.items()
    ]
    rows.append(["CGAL, as rigid as possible", *cells(cgal, mean), "", ""])
    return table(head, rows)


def muscle_table(solves):
    head = ["muscle", "vertices, of the hull", *(f"{s}, ms" for s in SOLVES.values())]
    head += ["CGAL over reference", "volume ratio of CGAL"]
    rows = []
    for muscle, found in solve_times(solves).items():
        arap, reference = found[ARAP], found["reference"]
        rows.append([
            plain(muscle),
            f"{arap['fine']:.0f}, {arap['coarse']:.0f}",
            *(f"{found[what]['real_time']:.1f}" for what in SOLVES),
            f"{arap['real_time'] / reference['real_time']:.1f}",
            f"{arap['volume_ratio']:.2f}",
        ])
    return table(head, rows)


def chapter(folder):
    solves = reports(folder, "solve_*")
    times = {
        (mode, threads): [
            median_time(steady_frames(report), "wall_ms")
            for report in reports(folder, f"mode_{mode}_{threads}_*")
        ]
        for mode in MODES
        for threads in (1, 2)
    }
    return [
        "    musclewarp-deform ... --contact=MODE --solver=SOLVER --threads=N\n"
        "    MUSCLEWARP_DATA_ROOT=DATA solve_benchmark "
        "--benchmark_filter='/(reference|ceres|arap_10)/'",
        prose(
            "Time for moving the muscles of a frame, without certificate and moment",
            "arms: the flags and frames are those of the chapter before. CGAL takes ten",
            "iterations of as-rigid-as-possible deformation of the same fine meshes",
            "from rest, one after the other, to flexion 60, on one thread and without",
            "contact. In each turn every mode runs once with either number of threads;",
            f"the table has the mean of all turns, {len(solves)} here, and the least and",
            "the most.",
        ),
        mode_table(times, cgal_turns(solves)),
        "One muscle alone, flexion 60 from rest without contact, one thread:",
        muscle_table(solves),
    ]
