#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes the chapter of the gait cycle of docs/performance.md and its plots, from what
benchmarks/gait.sh keeps in a folder.

  benchmarks/gait/gait_page.py OUT [PAGE]

Without PAGE the table is printed, and any frames will do; with PAGE both scenes need
all their frames. Needs the python3-numpy of Debian.
"""

import dataclasses
import json
import pathlib
import statistics
import sys

import numpy as np
import shared_path  # noqa: F401, where chapters, svg and table are
from chapters import markers, replaced  # noqa: F401, markers for tests
from gait_cycle import FRAMES, JOINTS, PERIOD, gait_cycle
from svg import BLUE, GREEN, ORANGE, Curve, Plot
from table import number, power, prose, table

SCRIPT = "benchmarks/gait.sh"
SCENES = ("thigh", "shank")
TIMES = ("wall_ms", "certify_ms", "moment_arms_ms")  # of a frame
MEGABYTE = 1024 * 1024


def seconds(frame):
    """The time of a frame with its certificate and measures."""
    return sum(frame.get(key) or 0 for key in TIMES) / 1000


@dataclasses.dataclass
class Walk:
    """A scene that went through the cycle, or a part of it."""

    prepared: dict  # the report of the run that made the preparation
    preparation: dict  # figures of measured.py of it
    report: dict  # the report of the motion, which read the preparation
    motion: dict
    disk_mb: float

    @property
    def frames(self):
        return self.report["frames"]

    @property
    def steady(self):
        """The frames but the first, which comes from the rest pose; if it is alone,
        that one."""
        return self.frames[1:] or self.frames

    def muscles(self, key):
        """The values of a key of all muscles in all frames."""
        return [muscle[key] for frame in self.frames for muscle in frame["muscles"]]

    def stretch(self, key):
        return max(shape["triangle_stretch"][key] for shape in self.muscles("shape"))


def read_walk(folder):
    def read(name):
        return json.loads((folder / name).read_text())

    files = [path for path in (folder / "run").rglob("*") if path.is_file()]
    walk = Walk(
        read("prepared.json"),
        read("preparation.json"),
        read("run/report.json"),
        read("motion.json"),
        sum(path.stat().st_size for path in files) / MEGABYTE,
    )
    if not walk.report["summary"]["finished"]:
        raise ValueError(f"{folder}: the run is not finished")
    return walk


def read_walks(out):
    """The scenes that have run, by name."""
    walks = {s: read_walk(out / s) for s in SCENES if (out / s / "motion.json").exists()}
    if not walks:
        raise ValueError(f"{out}: has no runs of {SCRIPT}")
    return walks


def size_rows(walks):
    def of(value):
        return [value(walk) for walk in walks]

    def vertices(walk):
        return sum(m["fine_vertices"] for m in walk.report["prepare"]["muscles"])

    def parts(walk):
        prepare = walk.report["prepare"]
        return f"{len(prepare['muscles'])}, {len(prepare['bones'])}"

    def memory(walk):
        return f"{walk.preparation['peak_mb']}, {walk.motion['peak_mb']}"

    return [
        ["muscles, bones", *of(parts)],
        ["vertices of muscles", *of(vertices)],
        ["most memory: preparation, motion, MB", *of(memory)],
        ["files of the motion, MB", *of(lambda walk: f"{walk.disk_mb:.0f}")],
    ]


def time_rows(walks):
    def of(value):
        return [value(walk) for walk in walks]

    def preparation(walk):
        prepare = walk.prepared["prepare"]
        return f"{(prepare['wall_ms'] + prepare.get('contact_ms', 0)) / 1000:.0f}"

    def first(walk):
        return f"{seconds(walk.frames[0]):.1f}, {walk.frames[0]['pose_steps']}"

    def spread(walk):
        times = [seconds(frame) for frame in walk.steady]
        middle = f"{statistics.mean(times):.2f}, {statistics.median(times):.2f}"
        return f"{middle}, {max(times):.2f}"

    def certificate(walk):
        return f"{statistics.mean(f['certify_ms'] for f in walk.steady) / 1000:.2f}"

    def steps(walk):
        counts = [frame["pose_steps"] for frame in walk.steady]
        return f"{sum(counts)}, {statistics.mean(counts):.2f}, {max(counts)}"

    return [
        ["preparation, cold, s", *of(preparation)],
        ["the motion, from start to end, s", *of(lambda w: f"{w.motion['wall_s']:.0f}")],
        ["first frame, from rest: s, steps", *of(first)],
        ["a later frame, with certificate: mean, median, longest, s", *of(spread)],
        ["of it certificate and measures, mean, s", *of(certificate)],
        ["steps of later frames: all, mean, most", *of(steps)],
    ]


def quality_rows(walks):
    def of(value):
        return [value(walk) for walk in walks]

    def usable(walk):
        return f"{sum(f['usable'] for f in walk.frames)} of {len(walk.frames)}"

    def gap(walk):
        gaps = [frame["smallest_gap_mm"] for frame in walk.frames]
        return number(min([gap for gap in gaps if gap is not None], default=0), 3)

    def displacement(walk):
        mean = statistics.mean(walk.muscles("mean_contact_displacement_mm"))
        return f"{mean:.3f}, {max(walk.muscles('max_contact_displacement_mm')):.1f}"

    def folded(walk):
        return max(sum(m["folded_triangles"] for m in f["muscles"]) for f in walk.frames)

    def drift(walk):
        areas = [area for some in walk.muscles("attachments") for area in some]
        return number(max((area["max_drift_mm"] for area in areas), default=0))

    def stretches(walk):
        return f"{walk.stretch('quantile_999'):.2f}, {walk.stretch('largest'):.2f}"

    def volume(walk):
        return power(max(abs(error) for error in walk.muscles("volume_error")))

    return [
        ["usable frames", *of(usable)],
        ["smallest gap, proved, mm", *of(gap)],
        ["largest stretch: of 99.9 % of a muscle, of a triangle", *of(stretches)],
        ["displacement by contact: mean, largest, mm", *of(displacement)],
        ["folded triangles of a frame, most", *of(folded)],
        ["largest drift of an attachment, mm", *of(drift)],
        ["largest error of a volume", *of(volume)],
    ]


def gait_table(walks):
    some = list(walks.values())
    rows = time_rows(some) + size_rows(some) + quality_rows(some)
    return table(["", *walks], rows)


def unusable_text(walks):
    """Which frames are not usable, and what the first of them lacks."""
    parts = []
    for name, walk in walks.items():
        bad = [frame for frame in walk.frames if not frame["usable"]]
        if bad:
            names = ", ".join(frame["name"] for frame in bad)
            why = "; ".join(bad[0]["shortcomings"]) or bad[0]["stop_reason"]
            parts.append(f"Not usable in the {name}: {names}. The first: {why}.")
    return " ".join(parts) or "All frames are usable."


def plot_times(walks, path):
    colors = dict(zip(SCENES, (BLUE, ORANGE)))
    curves = [
        Curve(
            name,
            np.array([100 * frame["time"] / PERIOD for frame in walk.steady]),
            np.array([seconds(frame) for frame in walk.steady]),
            colors[name],
        )
        for name, walk in walks.items()
    ]
    title = "Time of a frame with its certificate"
    Plot(title, "% of the gait cycle", "s", curves).write(path)


def plot_angles(path):
    frames, _ = gait_cycle()
    x = np.array([frame.percent for frame in frames])
    names = {"hip": "hip flexion", "knee": "knee flexion", "ankle": "ankle dorsiflexion"}
    curves = [
        Curve(names[joint], x, np.array([getattr(f, joint) for f in frames]), color)
        for joint, color in zip(JOINTS, (BLUE, ORANGE, GREEN))
    ]
    Plot("Angles of the joints", "% of the gait cycle", "degrees", curves).write(path)


def ranges_text():
    """The angles of the cycle, and those that were limited."""
    frames, outside = gait_cycle()
    spans = []
    for joint in JOINTS:
        angles = [getattr(frame, joint) for frame in frames]
        spans.append(f"{joint} {min(angles):.1f} to {max(angles):.1f}")
    cut = [f"{joint} in {count} frames" for joint, count in outside.items() if count]
    limits = "limited: " + ", ".join(cut) if cut else "none had to be limited"
    return f"Angles, degrees: {', '.join(spans)}; {limits}."


def machine_text(walks):
    reports = [r for walk in walks.values() for r in (walk.prepared, walk.report)]
    found = {
        (r["machine"]["processor"], r["machine"]["threads"], r["code"]) for r in reports
    }
    if len(found) > 1:
        raise ValueError("the runs are of several builds, machines or numbers of threads")
    processor, threads, code = found.pop()
    return f"{processor}, {threads} {'thread' if threads == 1 else 'threads'}, `{code}`."


def chapter(walks, plots):
    plot_times(walks, plots / "gait_times.svg")
    plot_angles(plots / "gait_angles.svg")
    return [
        f"    {SCRIPT} DATA OUT",
        prose(
            f"{machine_text(walks)} {ranges_text()} The preparation is made by a run of",
            "its own (`--frames=0:0`) and read from the cache by that of the motion;",
            "times of frames have all but the writing of files.",
        ),
        gait_table(walks),
        prose(unusable_text(walks)),
        f"![Time of a frame over the gait cycle]({plots.name}/gait_times.svg)",
        f"![Angles of the joints over the gait cycle]({plots.name}/gait_angles.svg)",
    ]


def write_page(out, page):
    """Puts the chapter between its markers; refuses parts of a cycle."""
    walks = read_walks(out)
    for name in SCENES:
        count = len(walks[name].frames) if name in walks else 0
        if count != FRAMES:
            raise ValueError(f"{out / name}: has {count} of {FRAMES} frames")
    plots = page.parent / page.stem
    text = page.read_text(encoding="utf-8")
    replaced(text, "Gait", [], SCRIPT)  # refuses before anything is written
    plots.mkdir(exist_ok=True)
    text = replaced(text, "Gait", chapter(walks, plots), SCRIPT)
    page.write_text(text, encoding="utf-8")


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    paths = [pathlib.Path(word).resolve() for word in sys.argv[1:]]
    try:
        if len(paths) == 2:
            write_page(*paths)
        else:
            walks = read_walks(paths[0])
            print("\n\n".join([gait_table(walks), prose(unusable_text(walks))]))
    except (ValueError, KeyError, OSError) as error:
        print(f"gait: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
