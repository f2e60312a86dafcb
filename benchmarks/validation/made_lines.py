# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Moment arms of lines that are made from meshes, against measured ones: the
criteria are those of DATA/literature/README.md, which has their reasons."""

import csv
import dataclasses

import numpy as np

import svg
from table import Row, Section, commands, paragraphs, prose, table, table_of

GUIDED = "_guided"  # ends the names of runs with --made_lines=guided

# The runs, and what their moving coordinate is called where arms are measured;
# -1: it counts the other way.
MOTIONS = {
    "made_knee": ("knee", "flexion", 1),
    "made_hamstrings": ("hip", "flexion", 1),
    "made_ankle": ("ankle", "plantarflexion", -1),
    "made_gastrocnemii": ("knee", "flexion", 1),
    "made_hip": ("hip", "flexion", 1),
    "made_shoulder": ("shoulder", "abduction", -1),
    "made_bellies": ("ankle", "plantarflexion", -1),
}
BELLIES = "made_bellies"  # as made_ankle, without tendons
KINDS = {"path": "path_moment_arms_mm", "carried": "line_moment_arms_mm"}

HAMSTRINGS = ["biceps_femoris_long", "semimembranosus", "semitendinosus"]
TRICEPS = ["soleus", "gastrocnemius_medial", "gastrocnemius_lateral"]
HEAD = ["muscle", "run", "criterion", "guided, path", "guided, carried"]
HEAD += ["taut, path", "taut, carried"]
HALF = 0.5  # mm: criteria are whole numbers


@dataclasses.dataclass
class Criterion:
    """What is asked of the mean arm of muscles over a run."""

    run: str
    muscles: list
    words: str
    measure: object  # of (angles, arms): what is compared
    low: float
    high: float
    digits: int = 0

    def value(self, angles, arms):
        """What is shown, and whether it is met."""
        values = np.atleast_1d(self.measure(angles, arms))
        slack = HALF if self.digits == 0 else 0
        met = values.min() >= self.low - slack and values.max() <= self.high + slack
        shown = [f"{value:.{self.digits}f}" for value in (values.min(), values.max())]
        return " to ".join(dict.fromkeys(shown)), bool(met)


def over(first, last):
    """The arms from one angle to another, degrees."""
    return lambda x, arms: arms[(x >= first - 1e-6) & (x <= last + 1e-6)]


def at(angle):
    return lambda x, arms: np.interp(angle, x, arms)


def ratio(angle, to):
    return lambda x, arms: np.interp(angle, x, arms) / np.interp(to, x, arms)


def peak(x, arms):
    """The angle of the largest arm."""
    return x[np.argmax(np.abs(arms))]


def criteria():
    """All criteria, with signs as in the literature."""

    def size(run, muscle, first, last, low, high):
        words = f"{low} to {high} mm over {first} to {last} degrees"
        return Criterion(run, [muscle], words, over(first, last), low, high)

    def change(run, muscle, angle, to, low, high):
        words = f"arm at {angle} over that at {to}: {low} to {high}"
        return Criterion(run, [muscle], words, ratio(angle, to), low, high, 2)

    listed = [
        size("made_knee", "semitendinosus", 30, 70, 28, 70),
        size("made_knee", "semimembranosus", 30, 70, 14, 52),
    ]
    for muscle in ("biceps_femoris_long", "biceps_femoris_short"):
        listed.append(size("made_knee", muscle, 20, 90, 14, 40))
        listed.append(change("made_knee", muscle, 90, 20, 0.6, 1.6))
    listed += [
        Criterion(
            "made_knee", ["gracilis"], "flexes from 30 degrees on", over(30, 90), 1, 99
        ),
        size("made_knee", "gracilis", 60, 90, 20, 40),
        size("made_hamstrings", "hamstrings", 0, 0, -79, -43),
        Criterion(
            "made_hamstrings", ["hamstrings"], "largest at 35 ± 20 degrees", peak, 15, 55
        ),
    ]
    for muscle in TRICEPS:
        listed.append(size("made_ankle", muscle, -20, 30, 34, 57))
        listed.append(change("made_ankle", muscle, 15, -15, 1.03, 1.35))
    for muscle in TRICEPS[1:]:
        listed.append(size("made_gastrocnemii", muscle, 20, 90, 8, 30))
    listed += [
        size("made_ankle", "tibialis_anterior", -15, 30, -46, -28),
        change("made_ankle", "tibialis_anterior", 30, -15, 0.6, 0.9),
        size("made_hip", "gluteus_maximus", 0, 0, -103, -30),
        Criterion(
            "made_hip",
            ["gluteus_maximus"],
            "extends over 0 to 90 degrees",
            over(0, 90),
            -999,
            -1,
        ),
        size("made_hip", "psoas_major", 0, 90, 20, 50),
        change("made_hip", "psoas_major", 90, 30, 1.1, 1.8),
        size("made_shoulder", "deltoid_clavicular", 10, 80, 4, 30),
        size("made_shoulder", "deltoid_acromial", 10, 80, 13, 29),
        size("made_shoulder", "deltoid_spinal", 10, 80, -14, 2),
        size("made_shoulder", "supraspinatus", 0, 30, 15, 30),
        change("made_shoulder", "supraspinatus", 80, 10, 0.2, 0.9),
        size("made_shoulder", "infraspinatus", 10, 80, 0, 20),
    ]
    return listed


def muscles_of(words):
    return HAMSTRINGS if words == ["hamstrings"] else words


def arms_of(run, muscles, kind):
    """Angles and mean arms of muscles, ascending, signs as in the literature."""
    sign = MOTIONS[run.name.removesuffix(GUIDED)][2]
    arms = []
    for frame in run.frames:
        values = []
        for muscle in frame["muscles"]:
            if muscle["name"].removesuffix("_r") not in muscles_of(muscles):
                continue
            of = frame if kind == "path" else muscle
            found = of[KINDS[kind]]
            lines = [
                found[line].get(run.moving, 0) for line in muscle["path_lengths_mm"]
            ]
            values.append(np.mean(lines))
        arms.append(sign * np.mean(values))
    order = np.argsort(sign * run.angles)
    return (sign * run.angles)[order], np.array(arms)[order]


def measured(data, joint, coordinate, words):
    """Measured arms of a muscle that hold at an angle and are not of a maximal
    contraction: angles and arms."""
    with open(data / "literature/moment_arms.csv", newline="") as file:
        rows = [
            (float(row["angle_deg"]), float(row["moment_arm_mm"]))
            for row in csv.DictReader(file)
            if row["joint"] == joint
            and row["coordinate"] == coordinate
            and words in row["muscle"]
            and row["condition"] != "MVC"
            and row["angle_deg"]
            and row["moment_arm_mm"]
        ]
    return np.array(rows).reshape(-1, 2)


# Plots: run, muscle, and the muscle of the literature.
PLOTS = [
    ("made_knee", "semitendinosus", "semitendinosus"),
    ("made_knee", "gracilis", "gracilis"),
    ("made_ankle", "soleus", "achilles"),
    ("made_ankle", "gastrocnemius_medial", "achilles"),
    ("made_ankle", "tibialis_anterior", "tibialis_anterior"),
    ("made_hip", "psoas_major", "psoas"),
    ("made_shoulder", "deltoid_acromial", "deltoid_middle"),
    ("made_shoulder", "supraspinatus", "supraspinatus"),
]


def draw(runs, name, muscle, words, data, plots):
    joint, coordinate, _ = MOTIONS[name]
    points = measured(data, joint, coordinate, words)
    curves = []
    for ending, label, color in ((GUIDED, "guided", svg.BLUE), ("", "taut", svg.ORANGE)):
        run = runs[name + ending]
        x, arms = arms_of(run, [muscle], "path")
        curves.append(svg.Curve(f"{label}, path", x, arms, color, "5 4", 1.5))
        x, arms = arms_of(run, [muscle], "carried")
        curves.append(svg.Curve(f"{label}, carried", x, arms, color, width=2.5))
    low, high = x.min(), x.max()
    inside = points[(points[:, 0] >= low) & (points[:, 0] <= high)]
    dots = [svg.Dots("measured", *inside.T, svg.GREEN)] if len(inside) else []
    file = f"{name}_{muscle}.svg"
    svg.Plot(
        f"{joint.capitalize()}, {muscle.replace('_', ' ')}",
        f"{coordinate}, degrees",
        "moment arm, mm",
        [*curves, *dots],
    ).write(plots / file)
    return f"![Moment arms of {muscle} over {coordinate}]({plots.name}/{file})"


def scored(asked, runs, instead=None, endings=(GUIDED, "")):
    """The cells of criteria, and which are met by kind of line and arm; of
    another run than they name, if one is given."""
    cells, held = [], {}
    for criterion in asked:
        name = instead or criterion.run
        row = [criterion.muscles[0].replace("_", " "), name, criterion.words]
        for ending in endings:
            for kind in KINDS:
                angles, arms = arms_of(runs[name + ending], criterion.muscles, kind)
                shown, met = criterion.value(angles, arms)
                row.append(f"{shown} {'🟢' if met else '🔴'}")
                held.setdefault(ending + kind, []).append(met)
        cells.append(row)
    return cells, held


def usable_words(runs):
    """Which of the taut runs have frames that are not usable."""
    counts = {name: [frame["usable"] for frame in runs[name].frames] for name in MOTIONS}
    short = [f"`{n}` {sum(u)} of {len(u)}" for n, u in counts.items() if not all(u)]
    if not short:
        return "All frames of the taut runs are usable."
    return f"""Not all frames of all taut runs are usable ({", ".join(short)}): contact
        moves a muscle farther there than it overlaps without. They count all the same."""


def bellies_parts(runs):
    """What is said of bellies without tendons."""
    asked = [criterion for criterion in criteria() if criterion.run == "made_ankle"]
    cells, held = scored(asked, runs, BELLIES, [""])
    met = {name: f"{sum(mets)} of {len(mets)}" for name, mets in held.items()}
    guided = [
        np.abs(arms_of(runs[BELLIES + GUIDED], criterion.muscles, kind)[1]).max()
        for criterion in asked
        for kind in KINDS
    ]
    words = prose(
        f"`{BELLIES}` is `made_ankle` with bellies without tendons, as most",
        "segmentations have them: there is no mesh of the calcaneal tendon, and the",
        "other muscles end above the ankle, cut by benchmarks/validation/bellies.py.",
        "Their lines go on to the bones",
        "[along tendons that no mesh has](method.md#tendons-without-a-mesh). Of these",
        f"criteria the paths meet {met['path']}, and the muscles as they carry them",
        f"{met['carried']}. Guided lines end where the meshes end, and have arms of",
        f"{max(guided):.0f} mm.",
    )
    return [words, table([*HEAD[:3], *HEAD[-2:]], cells)]


def made_lines_section(runs, data, plots):
    """The section of lines that are made: `runs` by name, of which those with
    --made_lines=guided end on GUIDED."""
    cells, held = scored(criteria(), runs)
    count = {name: f"{sum(mets)} of {len(mets)}" for name, mets in held.items()}
    rows = [
        Row(
            "criteria of measured moment arms that lines made from meshes hold, as paths",
            "more than guided lines",
            f"{count['path']} (guided {count[GUIDED + 'path']})",
            sum(held["path"]) > sum(held[GUIDED + "path"]),
        ),
        Row(
            "the same as the muscles carry them",
            "more than guided lines",
            f"{count['carried']} (guided {count[GUIDED + 'carried']})",
            sum(held["carried"]) > sum(held[GUIDED + "carried"]),
        ),
    ]
    shown = [runs[name].command for name in MOTIONS]
    body = paragraphs(
        prose(
            "Lines that are made from the meshes, at knee, ankle, hip and shoulder,",
            "beside measured moment arms (DATA/literature/moment_arms.csv, whose README",
            "has the sources and a fair criterion for each muscle). Signs are those of",
            "the literature: plantarflexion and flexion positive. An arm is",
            "the mean over the lines of a muscle; a criterion in whole millimetres is",
            "met to half of one. *Path* is the line itself, *carried* the line as the",
            "mesh carries it. *Guided* has `--made_lines=guided`. 🔴 marks what is",
            "wrong: the biceps of the thigh and the gracilis bowstring at the knee from",
            "80 degrees on, as nothing in the data says what holds them; measured arms of",
            "the hamstrings at the knee are few. The scapula does not move at our",
            "shoulder, as it does in what was measured, so that the same angle is a",
            "larger one of the joint. The line of the acromial part of the deltoid sinks",
            "into the head of the humerus as the arm is raised.",
            "benchmarks/validation.sh makes the scenes",
            "by musclewarp-articulate.",
            usable_words(runs),
        ),
        commands(shown),
        table_of(rows),
        table(HEAD, cells),
        *bellies_parts(runs),
        "\n".join(draw(runs, *plot, data, plots) for plot in PLOTS),
    )
    return Section("Lines made from meshes against measured moment arms", body, rows)
