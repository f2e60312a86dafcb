# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Moment arms of lines, against OpenSim and against specimens."""

import re
import xml.etree.ElementTree as ET

import numpy as np

import svg
from bands import Published, path_arms
from table import Row, Section, commands, mark, number, paragraphs, power, prose
from table import span, table, table_of

SLOPE = 0.1  # mm a degree, as the test of results.md allows
ARNOLD_MARGIN = 3  # mm
PSOAS = ["psoas_upper", "psoas_r"]  # one follows the other

def conditional_ranges(model, coordinate):
    """The ends (degrees) of the ranges of conditional points of each muscle
    of an OpenSim model: {muscle: [degrees]}."""
    root = ET.fromstring(model.read_text(encoding="latin-1"))
    ends = {}
    for muscle in root.iterfind(".//ForceSet/objects/*"):
        for point in muscle.iter("ConditionalPathPoint"):
            if point.findtext("coordinate", "").strip() == coordinate:
                values = [float(v) for v in point.findtext("range").split()]
                ends.setdefault(muscle.get("name"), []).extend(np.degrees(values))
    return ends


def slope_rows(run, ends):
    """Compares moment arms of straight paths with the slopes of the lengths;
    intervals in which a conditional point comes or goes do not count."""
    x, rows = run.angles, []
    lines = [name for lines in run.lines.values() for name in lines]
    for line in lines:
        length = run.column("lengths.sto", f"{line}_path")
        arm = run.column("moment_arms.sto", f"{line}_path.{run.moving}")
        slope = np.diff(length) / np.diff(x)
        difference = np.abs(slope + np.radians((arm[1:] + arm[:-1]) / 2))
        low, high = np.minimum(x[1:], x[:-1]), np.maximum(x[1:], x[:-1])
        steps = np.zeros(len(slope), bool)
        for end in ends.get(line, []):
            steps |= (low - 1e-3 <= end) & (end <= high + 1e-3) & (difference > SLOPE)
        where = [
            f"{difference[k]:.2f} from {low[k]:g} to {high[k]:g} degrees"
            for k in np.flatnonzero(steps)
        ]
        rows.append((line, difference[~steps].max(), "; ".join(where)))
    return rows


def opensim_row(out, results):
    """The comparison with OpenSim's table if there was one, else what
    docs/results.md reports of it."""
    requirement = "straight moment arms, all eight lines, against OpenSim 3.3"
    target = "at most 1e-5 mm, the last digit that OpenSim wrote"
    compared = out / "opensim.txt"
    if compared.exists():
        words = [line.split() for line in compared.read_text().splitlines()[1:]]
        name, worst = max(((w[0], float(w[1])) for w in words), key=lambda w: w[1])
        measured = f"{power(worst)} mm ({name})"
        return Row(requirement, target, measured, worst <= 1e-5)
    words = " ".join(results.read_text().split())
    found = re.search(r"difference is at most ([0-9.e-]+[0-9]) mm; TABLE", words)
    if not found:
        return Row(requirement, target, "not measured by this command", None)
    worst = float(found[1])
    source = "measured earlier, [results.md](results.md#moment-arms)"
    measured = f"{power(worst)} mm ({source})"
    return Row(requirement, target, measured, worst <= 1e-5)


def opensim_section(run, data, out, results):
    ends = conditional_ranges(data / "lhdl_hip/LHDL_hip_r.osim", run.moving)
    x = run.angles
    switches = [
        f"{name} at {end:.1f} degrees"
        for name, values in sorted(ends.items())
        for end in values
        if x.min() < end < x.max()
    ]
    slopes = slope_rows(run, ends)
    worst = max(slopes, key=lambda row: row[1])
    rows = [
        opensim_row(out, results),
        Row(
            "straight moment arms are the slopes of straight lengths",
            f"at most {SLOPE:g} mm a degree",
            f"{number(worst[1], 4)} mm a degree ({worst[0]})",
            worst[1] <= SLOPE,
        ),
    ]
    cells = [
        [name, number(value, 4), f"{SLOPE:g}", mark(value <= SLOPE), where or "none"]
        for name, value, where in slopes
    ]
    head = ["line", "largest difference, mm a degree", "target", "met?"]
    head += ["steps left out"]
    explained = prose(
        "The table of OpenSim is a file of modenaxe/3d-muscles and not part of DATA;",
        "`--opensim=TABLE` compares with it again. Two lines have a conditional point,"
        if len(switches) == 2
        else "Some lines have a conditional point,",
        f"which is switched off during the flexion: {', '.join(switches)}. There the",
        "straight length has a step and the moment arm a jump, in OpenSim as here. At",
        "OpenSim's own angles these lines agree as the others do. Between its angles a",
        "comparison interpolates across the jump, so that these lines differ near it,",
        "and only there.",
    )
    second = prose(
        "The second table compares the moment arms of this run with the slopes of its",
        "own straight lengths between two frames.",
    )
    body = paragraphs(
        explained, second, commands([run.command]), table_of(rows), table(head, cells)
    )
    return Section("Straight paths against OpenSim 3.3", body, rows)


def arnold_band(data, x):
    """The specimens of Arnold et al. at the angles x: angles x 3."""
    path = data / "literature/arnold2000_psoas_flexion.csv"
    table_ = np.loadtxt(path, delimiter=",", skiprows=1)
    return np.stack([np.interp(x, table_[:, 0], c) for c in table_[:, 1:].T], axis=1)


def inside_row(requirement, x, arm, low, high):
    """How many frames lie in a band, and where the others are how far off."""
    off = np.maximum(low - arm, arm - high)
    outside = off > 0
    measured = f"{(~outside).sum()} of {len(x)}"
    if outside.any():
        where = x[outside]
        measured += (
            f" (outside at {outside.sum()} angles between {where.min():g} and "
            f"{where.max():g} degrees, by up to {off.max():.1f} mm)"
        )
    return Row(requirement, f"{len(x)} of {len(x)} frames", measured, not outside.any())


def psoas_section(run, data, plots):
    x = run.angles
    carried, straight = (path_arms(run, PSOAS, kind) for kind in ("", "_path"))
    published = Published(data / "literature/blemker2005_hip_flexion.csv")
    specimens = arnold_band(data, x)
    low = specimens.min(axis=1) - ARNOLD_MARGIN
    high = specimens.max(axis=1) + ARNOLD_MARGIN
    rows = [
        inside_row(
            "carried psoas line in the band of Blemker and Delp",
            x,
            carried,
            *published.band("psoas_major_r", x),
        ),
        inside_row(
            f"carried psoas line in the range of Arnold et al., extended by "
            f"{ARNOLD_MARGIN} mm",
            x,
            carried,
            low,
            high,
        ),
    ]
    curves = [svg.Curve("", x, s, svg.GREEN, width=1) for s in specimens.T]
    label = f"Arnold et al. 2000, ±{ARNOLD_MARGIN} mm"
    range_ = svg.Band(label, x, low, high, svg.GREEN, opacity=0.18)
    svg.Plot(
        "Hip flexion, psoas line",
        "hip flexion, degrees",
        "moment arm, mm",
        [
            *published.drawn("psoas_major_r", x.min(), x.max()),
            range_,
            *curves,
            svg.Curve("carried", x, carried, svg.ORANGE, width=2.5),
            svg.Curve("straight", x, straight, svg.ORANGE, "5 4", 1.5),
        ],
    ).write(plots / "psoas_line.svg")
    cells = [
        [f"{x[k]:g}", f"{carried[k]:.1f}", f"{straight[k]:.1f}", span(specimens[k])]
        for k in range(0, len(x), 5)
    ]
    head = ["hip flexion, degrees", "carried, mm", "straight, mm", "specimens, mm"]
    picture = f"{plots.name}/psoas_line.svg"
    body = paragraphs(
        prose(
            "Arnold et al. (2000, doi 10.3109/10929080009148877) measured the psoas of",
            "three specimens by the excursion of its tendon; thin curves in the plot.",
            f"The lines `{PSOAS[0]}` and `{PSOAS[1]}` are one path, the second begins",
            "where the first ends; the sum of their moment arms, as their muscle",
            "carries them, is compared with the range of the specimens, extended by",
            f"{ARNOLD_MARGIN} mm, and with the band of Blemker and Delp.",
        ),
        commands([run.command]),
        table_of(rows),
        f"![Moment arms of the psoas line over hip flexion]({picture})",
        table(head, cells),
    )
    return Section("Psoas against measurements on specimens", body, rows)
