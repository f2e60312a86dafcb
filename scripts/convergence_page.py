#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes tables and plots of studies of convergence.

usage: scripts/convergence_page.py OUT [docs/convergence.md]

OUT has a folder with convergence.json for each study (scripts/convergence.sh).
The page is rewritten between its markers; plots are convergence_NAME.svg in
the folder `pictures` beside it. They need matplotlib (Debian:
python3-matplotlib).
"""
import json
import pathlib
import sys

BEGIN = "<!-- Studies: written by scripts/convergence_page.py; do not edit. -->"
END = "<!-- End of studies. -->"

STUDIES = {
    "vertices": "Size of hulls, vertices",
    "spacing": "Spacing of samples along lines, mm",
    "density": "Triangles of the meshes, as a multiple",
}


def solved_rows(report, study):
    return [row for row in report["rows"]
            if row["study"] == study and not row["failure"]]


def worst_of_frames(rows):
    """The worst row of each muscle and value by key, over all frames."""
    worst = {}
    for row in rows:
        at = worst.setdefault((row["muscle"], row["value"]), {
            "vertices": row["coarse_vertices"], "largest": 0, "mean": 0,
            "usable": True})
        at["largest"] = max(at["largest"], row["largest_distance_mm"])
        at["mean"] = max(at["mean"], row["mean_distance_mm"])
        at["usable"] = at["usable"] and row["usable"]
    return worst


def in_order(items):
    return list(dict.fromkeys(items))


def table(report, study):
    """The lines of the table of a study, the coarsest value first."""
    rows = solved_rows(report, study)
    if not rows:
        return []
    worst = worst_of_frames(rows)
    muscles = in_order(row["muscle"] for row in rows)
    finest = next(row["value"] for row in rows if row["finest"])
    values = [value for value in in_order(row["value"] for row in rows)
              if value != finest]
    if not values:
        return []
    lines = [f"{STUDIES[study]}, against {finest:g}:", "",
             "| muscle | " + " | ".join(f"{value:g}" for value in values)
             + " |", "|---" * (len(values) + 1) + "|"]
    for muscle in muscles:
        cells = [worst[muscle, value] for value in values]
        lines.append(f"| {muscle} | " + " | ".join(
            f"{cell['largest']:.2f}, {cell['mean']:.2f}"
            + ("" if cell["usable"] else " *") for cell in cells) + " |")
    if not all(cell["usable"] for cell in worst.values()):
        lines += ["", "(* a frame is not usable)"]
    for row in report["rows"]:
        if row["study"] == study and row["failure"]:
            lines += ["", f"{row['value']:g} could not be solved: "
                      f"{row['failure']}"]
    return lines + [""]


def plot(report, path):
    """Draws distance over vertices of hulls, one line for each muscle."""
    import matplotlib
    matplotlib.use("svg")
    matplotlib.rcParams.update({"svg.hashsalt": "musclewarp",
                                "svg.fonttype": "none",
                                "font.family": "sans-serif"})
    import matplotlib.pyplot as plt
    rows = solved_rows(report, "vertices")
    worst = worst_of_frames(rows)
    colours = plt.get_cmap("tab20").colors
    figure, axes = plt.subplots(1, 2, figsize=(10, 4.5), sharex=True)
    for axis, key in zip(axes, ("mean", "largest")):
        for i, muscle in enumerate(in_order(row["muscle"] for row in rows)):
            # The finest is at no distance from itself, which has no logarithm.
            line = [(at["vertices"], at[key])
                    for (name, _), at in worst.items()
                    if name == muscle and at[key] > 0]
            if line:
                axis.loglog(*zip(*line), "o-", markersize=3, label=muscle,
                            color=colours[i % len(colours)])
        axis.set_xlabel("vertices of the hull")
        axis.set_ylabel(f"{key} distance from the finest, mm")
        axis.grid(True, which="both", linewidth=0.3)
    axes[1].legend(fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


def section(name, report, pictures):
    poses = in_order(row["pose"] for row in report["rows"]
                     if not row["failure"])
    as_set = report["as_set"]
    lines = [f"## {name.replace('_', ' ')}", "",
             f"Scene {report['scene']}, contact {report['contact']}, poses "
             f"{', '.join(poses)}; hulls of {as_set['coarse_vertices']} "
             f"vertices and samples every {as_set['sample_spacing_mm']:g} mm "
             "where they are not varied. Largest and mean distance, mm, the "
             "worst of all poses.", ""]
    if len(solved_rows(report, "vertices")) > 0:
        picture = f"convergence_{name}.svg"
        pictures.mkdir(exist_ok=True)
        plot(report, pictures / picture)
        lines += [f"![Distance from the finest hull over vertices of the hull]"
                  f"(pictures/{picture})", ""]
    for study in STUDIES:
        lines += table(report, study)
    return lines


def main(arguments):
    if len(arguments) not in (1, 2):
        sys.exit(__doc__)
    root = pathlib.Path(__file__).resolve().parent.parent
    page = pathlib.Path(arguments[1] if len(arguments) == 2
                        else root / "docs/convergence.md")
    files = sorted(pathlib.Path(arguments[0]).glob("*/convergence.json"))
    if not files:
        sys.exit(f"{arguments[0]}: has no folder with convergence.json; run "
                 "scripts/convergence.sh first")
    text = page.read_text()
    if BEGIN not in text or END not in text:
        sys.exit(f"{page}: has no markers to write between")
    lines = []
    for file in files:
        lines += section(file.parent.name, json.loads(file.read_text()),
                         page.parent / "pictures")
    before, rest = text.split(BEGIN, 1)
    after = rest.split(END, 1)[1]
    page.write_text(before + BEGIN + "\n\n" + "\n".join(lines) + "\n" + END
                    + after)


if __name__ == "__main__":
    main(sys.argv[1:])
