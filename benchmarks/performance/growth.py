# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The chapter of how times grow with the muscles and with the resolution."""

import dataclasses

import numpy as np
import shared  # noqa: F401, where svg and table are
from figures import reports
from log_plot import LogPlot, Points
from svg import BLUE, ORANGE, Curve
from table import prose, table


@dataclasses.dataclass
class Sample:
    """A random scene and the times of it, ms."""

    seed: int
    muscles: int
    vertices: int  # of the fine meshes of muscles
    usable: str  # how many of its frames are
    steps: int
    step: float
    certificate: float  # of a frame, with measures


def sample_of(report, seed):
    # The first frame is the rest pose, where steps have little to do.
    frames = report["frames"][1:]
    muscles = report["prepare"]["muscles"]
    steps = sum(frame["pose_steps"] for frame in frames)
    return Sample(
        seed,
        len(muscles),
        sum(muscle["fine_vertices"] for muscle in muscles),
        f"{sum(frame['usable'] for frame in frames)} of {len(frames)}",
        steps,
        sum(frame["wall_ms"] for frame in frames) / steps,
        sum(frame["certify_ms"] for frame in frames) / len(frames),
    )


def samples_of(folder, kind):
    """The samples of reports that are named KIND_SEED_NUMBER, by their size."""
    samples = [
        sample_of(report, int(file.stem.split("_")[1]))
        for file, report in zip(
            sorted(folder.glob(f"{kind}_*.json")), reports(folder, f"{kind}_*")
        )
    ]
    return sorted(samples, key=lambda s: (s.seed, s.muscles, s.vertices))


def fitted_power(x, y):
    """Returns power and factor of y = factor * x^power by least squares of logs."""
    if np.ptp(x) == 0:
        raise ValueError(f"no power fits one size alone, {x[0]:g}")
    power, log_factor = np.polyfit(np.log(x), np.log(y), 1)
    return power, np.exp(log_factor)


def plot_growth(samples, size, title, x_label, path):
    """Plots the times over a size, such as "muscles"; returns the powers."""
    x = np.array([getattr(sample, size) for sample in samples], float)
    ends, items, powers = np.array([x.min(), x.max()]), [], []
    for what, color in {"step": BLUE, "certificate": ORANGE}.items():
        y = np.array([getattr(sample, what) for sample in samples])
        power, factor = fitted_power(x, y)
        label = f"{what}, power {power:.2f}"
        items.append(Curve(label, ends, factor * ends**power, color, "5 4"))
        items.append(Points("", x, y, color))
        powers.append(power)
    LogPlot(title, x_label, "ms", items).write(path)
    return powers


def sample_table(samples):
    head = ["seed", "muscles", "vertices", "usable frames", "steps"]
    head += ["step, ms", "certificate, ms"]
    rows = [
        [*dataclasses.astuple(s)[:5], f"{s.step:.0f}", f"{s.certificate:.0f}"]
        for s in samples
    ]
    return table(head, rows)


def chapter(folder, plots):
    by_muscles, by_vertices = (samples_of(folder, k) for k in ("muscles", "vertices"))
    files = plots / "growth_muscles.svg", plots / "growth_vertices.svg"
    title = "Random scenes, certified contact"
    plot_growth(by_muscles, "muscles", title, "muscles", files[0])
    title = "One random scene with finer meshes"
    plot_growth(by_vertices, "vertices", title, "vertices of muscles", files[1])
    pictures = [
        f"![Time of a step and of the certificate over {what}]({plots.name}/{file.name})"
        for what, file in zip(("muscles", "vertices"), files)
    ]
    return [
        "    musclewarp-phantom --scene=random --seed=SEED --num_muscles=N --out=SCENE\n"
        "    musclewarp-deform --scene=SCENE/scene.json",
        prose(
            "Means over all frames but the first, of a step and of the certificate with",
            "the measures of a frame, with all threads. A scene of more muscles has the",
            "muscles of a smaller one of the same seed among them. Lines are powers",
            "that fit best.",
        ),
        pictures[0],
        sample_table(by_muscles),
        "    benchmarks/performance/refined_scene.py SCENE CUTS FINER_SCENE",
        prose(
            "cuts every edge of the meshes of muscles and bones into two, three, ...;",
            "surfaces and lines are as before, and hulls have as many vertices:",
        ),
        pictures[1],
        sample_table(by_vertices),
    ]
