# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Lengths, sections and thickness of muscles, against those measured on people:
DATA/literature/shape_facts.csv, which has the sources."""

import numpy as np

import sections
import svg
from courses import Course
from facts import HEAD, IMPOSED, MESH, Facts, line_of, values
from table import Row, Section, commands, paragraphs, plain, power, prose, table
from table import table_of

RUNS = ["made_ankle", "made_gastrocnemii", "made_knee", "made_hamstrings", "made_hip"]
TRICEPS = ["soleus", "gastrocnemius_medial", "gastrocnemius_lateral"]
HAMSTRINGS = ["semimembranosus", "semitendinosus", "biceps_femoris_long"]
NEAR = 10  # % of the thigh: sources give no spread of places
SOME = 0.1  # of a ratio without a spread
MUCH = 2  # times, for what a source calls much more
DEVIATIONS = 2  # standard deviations that persons may differ
LOWER, PATCH = 60, 15  # mm: the lower part of a hip bone, and of the tuberosity in it
BACK = np.array([0.0, 1.0, 0.0])  # in LPS


def calf_lines(facts, runs):
    rows = facts.find("triceps_surae", "change of fibre length", "rest", "mm")
    percent = facts.find("triceps_surae", "change of fibre length", "rest", "%")
    (belly,) = facts.find(
        "gastrocnemius_medialis", "belly elongation over fascicle elongation", "rest"
    )
    start, end = (float(rows[0][key]) for key in ("angle_from_deg", "angle_to_deg"))
    where = f"from {start:g} to {end:g} degrees of plantarflexion"
    courses = [Course(runs["made_ankle"], muscle, -1) for muscle in TRICEPS]
    changes = np.array([course.change(start, end, fibres=True) for course in courses])
    before = [np.interp(start, course.angles, course.fibres) for course in courses]
    lines = []
    parts = 100 * changes / before
    for found, unit, ours in ((rows, "mm", changes), (percent, "%", parts)):
        low, high = values(found)
        held = all(low <= round(value) <= high for value in ours)
        shown = ", ".join(f"{plain(m)} {v:.0f}" for m, v in zip(TRICEPS, ours))
        measured = f"{low:g} to {high:g} {unit}"
        what = f"change of fibre length {where}"
        lines.append(line_of(found[0], measured, f"{shown} {unit}", held, what))
    ratio, medial = float(belly["value"]), TRICEPS.index("gastrocnemius_medial")
    ours = courses[medial].change(start, end)
    low, high = (round(ratio * value) for value in values(rows))
    measured = f"{low} to {high} mm ({ratio:g} times the fibres above)"
    what, held = f"change of belly length {where}", low <= round(ours) <= high
    lines.append(line_of(belly, measured, f"{ours:.0f} mm", held, what))
    gear = ours / changes[medial]
    held = abs(gear / ratio - 1) < SOME
    lines.append(line_of(belly, f"{ratio:g}", f"{gear:.2f}", held))
    (row,) = facts.find(
        "gastrocnemius_medialis",
        "fascicle length change per change of muscle-tendon length",
        "rest",
    )
    ankle, knee = (
        Course(runs[name], "gastrocnemius_medial").gear()
        for name in ("made_ankle", "made_gastrocnemii")
    )
    ours = f"{ankle:.2f} by ankle, {knee:.2f} by knee (belly)"
    lines.append(line_of(row, "", ours, ankle > knee))
    return lines


def tibialis_lines(facts, runs):
    course = Course(runs["made_ankle"], "tibialis_anterior", -1)
    volume, mean, place = (
        facts.find("tibialis_anterior", quantity, "active and passive")[0]
        for quantity in (
            "volume over muscle length",
            "mean cross-section with shortening",
            "place of the largest cross-section with shortening",
        )
    )
    # It shortens from the last angle to the first.
    change = course.volume_change()
    short, long = course.lengths[[0, -1]]
    rise = 100 * (long / short - 1)
    first, last = course.largest_sections()[1][[0, -1]]
    kept, risen = f"changes by {power(change)}", f"{rise:+.0f} %"
    risen += f" ({long:.0f} to {short:.0f} mm long)"
    return [
        line_of(volume, "constant", kept, change < 1e-3, note=IMPOSED),
        line_of(mean, "", risen, rise > 0, note=IMPOSED),
        line_of(
            place, "", f"{last:.0f} to {first:.0f} mm from the upper end", first < last
        ),
    ]


def thigh_place(run, muscles):
    """Where the largest section across the femur is, % of it from the knee."""
    bone, _ = run.mesh("rest", "femur")
    axis = np.linalg.svd(bone - bone.mean(axis=0), full_matrices=False)[2][0]
    axis *= np.sign(axis[2])
    low, high = (bone @ axis).min(), (bone @ axis).max()
    parts = np.linspace(0, 100, 101)
    meshes = [run.mesh("rest", muscle) for muscle in muscles]
    areas = [
        sum(sections.plane_area(*mesh, axis, axis * height) for mesh in meshes)
        for height in low + (high - low) * parts / 100
    ]
    return sections.peak_of(parts, np.array(areas))


def thigh_lines(facts, runs):
    lines = []
    for name, muscles in (
        ("gracilis", ["gracilis"]),
        ("semimembranosus", ["semimembranosus"]),
        ("biceps_femoris", ["biceps_femoris_long", "biceps_femoris_short"]),
    ):
        (row,) = facts.find(name, "place of the largest cross-section", "rest")
        ours = thigh_place(runs["made_knee"], muscles)
        wanted = float(row["value"])
        measured, held = f"{wanted:.0f} {row['unit']}", abs(ours - wanted) <= NEAR
        lines.append(line_of(row, measured, f"{ours:.0f} %", held, note=MESH))
    hip, knee = (
        {m: Course(runs[name], m).change(0, 90) for m in HAMSTRINGS}
        for name in ("made_hamstrings", "made_knee")
    )
    over = {m: hip[m] - knee[m] for m in HAMSTRINGS}
    (row,) = facts.find(
        "semimembranosus", "length change over hip 0 and 90, knee 0, 45 and 90", "rest"
    )
    ours = ", ".join(f"{plain(m)} {over[m]:.0f} mm" for m in HAMSTRINGS)
    held = max(over, key=over.get) == "semimembranosus"
    lines.append(line_of(row, "", ours, held))
    (row,) = facts.find("biceps_femoris", "length change by hip against knee", "cadaver")
    by_hip, by_knee = hip["biceps_femoris_long"], abs(knee["biceps_femoris_long"])
    ours = f"{by_hip:.0f} mm by hip, {by_knee:.0f} mm by knee (0 to 90 degrees each)"
    lines.append(line_of(row, "", ours, by_hip >= MUCH * by_knee))
    return lines


def seat_thickness(run, folder):
    """The mean thickness of the gluteus maximus behind the ischial tuberosity."""
    bone, _ = run.mesh(folder, "hip_bone_r")
    lower = bone[bone[:, 2] < bone[:, 2].min() + LOWER]
    tip = lower[(lower @ BACK).argmax()]
    patch = bone[np.linalg.norm(bone - tip, axis=1) < PATCH]
    mesh = run.mesh(folder, "gluteus_maximus_r")
    return np.mean([sections.thickness(*mesh, point, BACK) for point in patch])


def seat_line(facts, runs):
    (row,) = facts.find(
        "gluteus_maximus",
        "change of muscle thickness over the ischial tuberosity",
        "rest, not loaded",
    )
    run = runs["made_hip"]
    ends = [float(row[key]) for key in ("angle_from_deg", "angle_to_deg")]
    frames = [int(np.abs(run.angles - angle).argmin()) for angle in ends]
    before, after = (seat_thickness(run, run.frame_folders()[k]) for k in frames)
    ours = 100 * (after / before - 1)
    wanted, spread = float(row["value"]), float(row["sd"])
    measured = f"{wanted:g} ± {spread:g} %"
    shown = f"{ours:.0f} % ({before:.0f} to {after:.0f} mm)"
    held = abs(ours - wanted) <= DEVIATIONS * spread
    unusable = [run.place(k) for k in frames if not run.frames[k]["usable"]]
    if unusable:
        shown += f"; the frame at {' and '.join(unusable)} is not usable"
    return line_of(row, measured, shown, held and not unusable)


COLORS = [svg.ORANGE, svg.BLUE, svg.GREEN]

# Plots: run, its sign, the words of its axis, and muscles.
PLOTS = [
    (
        "made_ankle",
        -1,
        "plantarflexion",
        ["soleus", "gastrocnemius_medial", "tibialis_anterior"],
    ),
    ("made_knee", 1, "knee flexion", HAMSTRINGS),
]


def draw(runs, name, sign, words, muscles, plots):
    curves = []
    for muscle, color in zip(muscles, COLORS):
        course = Course(runs[name], muscle, sign)
        for label, values_, dashes in (
            (plain(muscle), course.lengths, ""),
            ("", course.largest_sections()[0], "5 4"),
        ):
            relative = 100 * values_ / np.interp(0, course.angles, values_)
            curves.append(svg.Curve(label, course.angles, relative, color, dashes))
    file = f"shapes_{name}.svg"
    svg.Plot(
        f"Length (solid) and largest section (dashed) over {words}",
        f"{words}, degrees",
        "% of that at 0 degrees",
        curves,
    ).write(plots / file)
    return f"![Length and largest section over {words}]({plots.name}/{file})"


ABOUT = f"""
Facts of DATA/literature/shape_facts.csv of which the runs of [section
4](#4-lines-made-from-meshes-against-measured-moment-arms) say something: how long
muscles are, where and how thick. The length of a muscle or belly is the mean of its
lines, from end to end; that of fibres is the mean of up to 50. Our fibres follow the
lines and end on attachments, not on aponeuroses: pennation, short fascicles in a long
belly, and active muscles are not modelled, and what depends on these is 🔴 or left
out. 🔴 of a trend means that it is not there. Sections are across the mean of the
lines; those of the thigh at rest are across the femur, whose length is from its
lowest to its highest point. They are of the meshes as they came (*mesh*), so they say
how far this body is like those of the study rather than how well it is deformed; to
be held they have to be within {NEAR} % of the thigh. *Much more* is taken as at least
twice. The thickness of the gluteus maximus is the mean along straight lines backwards
from the tuberosity ({PATCH} mm around its hindmost point), and is held within two
standard deviations, of frames that are usable.
"""

WRONG = """
What is wrong: the fibres of the calf are nearly as long as the belly and shorten
nearly as much, which is too many millimetres for fascicles, and in relation to their
length less than half of what is measured. Semitendinosus and biceps change their
length more than semimembranosus, and the biceps shortens too much by the knee, where
it bowstrings (section 4). The gluteus maximus thins by less than the mean of the
people measured, at the edge of what would be held, and in a frame that contact has
moved too far. Not counted is what the method imposes (*imposed*): it keeps volumes,
and so the mean section rises as a muscle shortens. Nor are the places of the largest
sections of the thigh at rest: the meshes differ there from the study, whatever
deforms them.
"""


def shapes_section(runs, data, plots):
    facts = Facts(data)
    lines = [
        *calf_lines(facts, runs),
        *tibialis_lines(facts, runs),
        *thigh_lines(facts, runs),
        seat_line(facts, runs),
    ]
    marks = [line[HEAD.index("held?")] for line in lines]
    asked = [mark for mark in marks if not mark.endswith((MESH, IMPOSED))]
    held = sum(mark.startswith("🟢") for mark in asked)
    row = Row(
        "measured facts on the change of lengths and shapes that runs show",
        "all",
        f"{held} of {len(asked)}",
        held == len(asked),
    )
    body = paragraphs(
        prose(ABOUT),
        commands([runs[name].command for name in RUNS]),
        table_of([row]),
        table(HEAD, lines),
        prose(WRONG),
        "\n".join(draw(runs, *plot, plots) for plot in PLOTS),
    )
    return Section("Shapes against measured ones", body, [row])
