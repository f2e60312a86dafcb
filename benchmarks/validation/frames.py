# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""What holds in every frame: attachments, volumes, contact, slices, lengths."""

import dataclasses

import numpy as np

import slices
from table import Row, Section, commands, mark, number, paragraphs, plain, power, prose
from table import span, table, table_of

MEAN_DRIFT, LARGEST_DRIFT = 0.5, 2.0  # mm
VOLUME_ERROR = 1e-6
FOLDED_SHARE = 0.001  # of the triangles of a muscle
JUMP = 2.5  # largest change of a length over its median change
SMALL_CHANGE = 0.1  # mm: below this a change is no jump
WORST_AREAS = 8


@dataclasses.dataclass
class Area:
    """An attachment area of a muscle over all frames of a run."""

    run: str
    muscle: str
    body: str
    kind: str  # published if the scene names it, else found
    mean: float = 0
    largest: float = 0
    place: str = ""  # where it drifts farthest

    def met(self):
        return self.mean <= MEAN_DRIFT and self.largest <= LARGEST_DRIFT

    def name(self):
        return f"{self.run}, {plain(self.muscle)} on {plain(self.body)}"


def kinds_of(run):
    """Whether the areas of each muscle are published or found on the meshes."""
    return {
        muscle["name"]: [
            "found" if area["found"] else "published" for area in muscle["attachments"]
        ]
        for muscle in run.report["prepare"]["muscles"]
    }


def areas_of(run):
    """All areas of a run, those that drift farthest first; without those that
    hold no vertex."""
    areas, kinds = {}, kinds_of(run)
    for index, frame in enumerate(run.frames):
        for muscle in frame["muscles"]:
            for k, found in enumerate(muscle["attachments"]):
                if not found["vertices"]:
                    continue
                name = muscle["name"]
                new = Area(run.name, name, found["body"], kinds[name][k])
                area = areas.setdefault((name, k), new)
                area.mean = max(area.mean, found["mean_drift_mm"])
                if found["max_drift_mm"] > area.largest:
                    area.largest = found["max_drift_mm"]
                    area.place = run.place(index)
    return sorted(areas.values(), key=lambda a: (-a.largest, -a.mean))


def unheld_areas(run):
    """The areas that hold no vertex, in words."""
    return [
        f"{plain(muscle['name'])} on {plain(area['body'])}"
        for muscle in run.frames[0]["muscles"]
        for area in muscle["attachments"]
        if not area["vertices"]
    ]


def folded_fraction(run):
    """The largest number of folded triangles of a muscle in a frame, and their
    largest share."""
    triangles = {name: len(run.mesh("rest", name)[1]) for name in run.muscles}
    folded = [
        (m["folded_triangles"], m["folded_triangles"] / triangles[m["name"]])
        for frame in run.frames
        for m in frame["muscles"]
    ]
    return max(count for count, _ in folded), max(share for _, share in folded)


def frame_rows(runs):
    """What is asked of every frame of some runs."""
    frames = [frame for run in runs for frame in run.frames]
    usable = sum(frame["usable"] for frame in frames)
    planned = sum(run.report["summary"]["frames_planned"] for run in runs)
    muscles = [muscle for frame in frames for muscle in frame["muscles"]]
    error = max(abs(muscle["volume_error"]) for muscle in muscles)
    change = max(abs(muscle["volume_ratio"] - 1) for muscle in muscles)
    counts = [folded_fraction(run) for run in runs]
    folded, share = (max(values) for values in zip(*counts))
    crossing = sum(frame["intersections"]["triangle_pairs"] for frame in frames)
    gaps = [f["smallest_gap_mm"] for f in frames if f["smallest_gap_mm"] is not None]
    wanted = max(run.report["contact_options"]["gap_mm"] for run in runs)
    gap = min(gaps, default=2)  # farther apart is not counted
    warnings = sum(len(run.report["warnings"]) for run in runs)
    return [
        Row("usable frames", "all", f"{usable} of {planned}", usable == planned),
        Row("crossing triangle pairs, all frames", "0", f"{crossing}", crossing == 0),
        Row(
            "largest volume error",
            f"at most {power(VOLUME_ERROR)}",
            power(error),
            error <= VOLUME_ERROR,
        ),
        Row("largest change of a delivered volume", "none set", power(change), None),
        Row(
            "folded triangles of a muscle",
            f"at most {100 * FOLDED_SHARE:g} %",
            f"{100 * share:.2g} % (at most {folded} in a frame)" if folded else "none",
            share <= FOLDED_SHARE,
        ),
        Row("smallest gap", f"at least {wanted:g} mm", f"{gap:.3f} mm", gap >= wanted),
        Row("warnings of report.json", "none", str(warnings or "none"), warnings == 0),
    ]


def drift_rows(areas, kind):
    """The rows of the published or the found areas."""
    areas = [area for area in areas if area.kind == kind]
    if not areas:
        return []
    mean = max(areas, key=lambda a: a.mean)
    largest = max(areas, key=lambda a: a.largest)
    return [
        Row(
            f"largest mean drift of a {kind} attachment area",
            f"at most {MEAN_DRIFT:g} mm",
            f"{number(mean.mean)} mm ({mean.name()})",
            mean.mean <= MEAN_DRIFT,
        ),
        Row(
            f"largest drift of a vertex of a {kind} attachment area",
            f"at most {LARGEST_DRIFT:g} mm",
            f"{number(largest.largest)} mm ({largest.name()})",
            largest.largest <= LARGEST_DRIFT,
        ),
    ]


def attachments_of(run, areas):
    """The tables of a run."""
    head = ["muscle", "body", "area", "largest mean, mm", "largest, mm", "at", "met?"]
    failed = [area for area in areas if not area.met()]
    rest = [area for area in areas if area.met()]
    shown = failed + rest[: max(0, WORST_AREAS - len(failed))]
    cells = [
        [plain(a.muscle), plain(a.body), a.kind, number(a.mean), number(a.largest)]
        + [a.place, mark(a.met())]
        for a in shown
    ]
    counted = f"{len(areas)} areas, {len(failed)} of them beyond a target"
    lost = unheld_areas(run)
    if lost:
        counted += f"; the mesh does not reach {len(lost)} more ({', '.join(lost)})"
    if len(shown) < len(areas):
        counted += f"; the {len(shown)} worst are listed"
    return paragraphs(
        f"**{run.name}**: {counted}.",
        commands([run.command]),
        table(head, cells),
        table_of(frame_rows([run])),
        "\n".join(f"- {warning}" for warning in run.report["warnings"]),
    ).rstrip()


def attachments_section(runs):
    areas = {run.name: areas_of(run) for run in runs}
    every = [area for of_run in areas.values() for area in of_run]
    rows = drift_rows(every, "published") + drift_rows(every, "found")
    rows += frame_rows(runs)
    body = paragraphs(
        prose(
            "The drift of a vertex is its distance from where its bone has it, counted",
            "from rest once nothing crossed. The tables give the largest mean and the",
            "largest maximum of each attachment area over the frames: of published",
            "areas, which the scene names, and of those found on the meshes, where it",
            "names none. Targets are",
            f"a mean of at most {MEAN_DRIFT:g} mm and",
            f"a maximum of at most {LARGEST_DRIFT:g} mm. Gaps are proved lower bounds.",
            "The volume error is counted from rest once nothing crossed; a delivered",
            "volume also changes as crossings of a mesh with itself are removed.",
            "Of folded triangles the largest share of a muscle in a frame is given.",
            "report.json warns of what is beyond anatomy.",
        ),
        *(attachments_of(run, areas[run.name]) for run in runs),
    )
    return Section("Attachments, volumes and contact", body, rows)


ABOUT_SLICES = f"""
The volume of each muscle is a constraint, but is it kept along the muscle?
Planes across the chord of its lines cut the rest mesh into {slices.SLICES}
slices of equal volume, from the beginning of its lines (1) to their end
({slices.SLICES}). The loops in which the planes cut the surface move with it, a
fan from its centre closes each loop, and the ratio is the volume between two
neighbouring loops over that at rest. The ratios of the slices average to that
of the muscle, and rigid motion leaves them at 1. Where a loop does not stay
plane, the ratio depends on the fan; the last column says by how much at most it
changes if the centres are moved towards one end of the loop. Rest is the mesh
in `rest` of the run, before anything was separated. No target is set.
"""


def slice_cells(run, muscle):
    """A row of the table, and the least and the largest ratio."""
    ratios = slices.slice_ratios(run, muscle)
    if ratios is None:
        return [run.name, plain(muscle), "mesh made anew", "", ""], 1, 1
    doubt = np.abs(ratios[:, 0] - ratios[:, 1]).max()
    ratios = ratios[:, 0]
    where = []
    for flat in (ratios.argmin(), ratios.argmax()):
        frame, which = np.unravel_index(flat, ratios.shape)
        place = f"slice {which + 1}, {run.place(frame)}"
        where.append(f"{ratios.flat[flat]:.3f} ({place})")
    cells = [run.name, plain(muscle), *where, number(doubt, 3)]
    return cells, ratios.min(), ratios.max()


def slices_section(runs):
    head = ["run", "muscle", "least ratio", "largest ratio", "by other centres"]
    cells, rows = [], []
    for run in runs:
        found = [slice_cells(run, muscle) for muscle in run.muscles]
        cells += [row for row, _, _ in found]
        least = min((low, row[1]) for row, low, _ in found)
        most = max((high, row[1]) for row, _, high in found)
        measured = f"{least[0]:.2f} ({least[1]}) to {most[0]:.2f} ({most[1]})"
        requirement = f"{run.name}: volume ratios of slices along the muscles"
        rows.append(Row(requirement, "none set", measured, None))
    body = paragraphs(
        prose(ABOUT_SLICES), commands([run.command for run in runs]), table(head, cells)
    )
    return Section("Volume along the muscles", body, rows)


def jumps(lengths):
    """The largest change of each length from frame to frame (mm), and its
    ratio to the median change; 0 if the change is too small to tell."""
    changes = np.abs(np.diff(lengths, axis=0))
    largest = changes.max(axis=0)
    ratio = largest / np.maximum(np.median(changes, axis=0), 1e-12)
    return largest, np.where(largest < SMALL_CHANGE, 0, ratio)


def lengths_of(run, muscle):
    """The carried lines and the fibres of a muscle: what they are, their names
    and their lengths (frames x lines)."""
    lines = list(run.lines[muscle])
    carried = np.stack([run.column("lengths.sto", line) for line in lines], axis=1)
    fibres = run.columns("fibre_lengths.sto", f"{muscle}_fibre_")
    names = [f"fibre {k + 1}" for k in range(fibres.shape[1])]
    return [("lines", lines, carried), ("fibres", names, fibres)]


def smoothness_row(run, found):
    """The row of the summary: `found` has the worst ratio, its name, and the
    numbers of lines beyond the target and in all."""
    worst, name = max((ratio, name) for ratio, name, _, _ in found)
    beyond, total = (sum(row[k] for row in found) for k in (2, 3))
    return Row(
        f"{run.name}: largest change of a length over its median change",
        f"at most {JUMP:g}",
        f"{worst:.2f} ({name}); {beyond} of {total} lines and fibres are beyond",
        beyond == 0,
    )


def smoothness_section(runs):
    head = ["run", "muscle", "of", "worst ratio", "target", "met?", "largest change"]
    head += [f"above {JUMP:g}"]
    cells, rows = [], []
    for run in runs:
        found = []
        for muscle in run.muscles:
            for kind, names, lengths in lengths_of(run, muscle):
                largest, ratio = jumps(lengths)
                k, above = ratio.argmax(), (ratio > JUMP).sum()
                worst = f"{ratio[k]:.2f} ({names[k]})" if ratio[k] else "small changes"
                count = f"{len(names)} {kind if len(names) > 1 else kind[:-1]}"
                cells.append(
                    [run.name, plain(muscle), count, worst]
                    + [f"{JUMP:g}", mark(above == 0), f"{largest[k]:.2f} mm", above]
                )
                found.append(
                    (ratio[k], f"{plain(muscle)}, {names[k]}", above, len(names))
                )
        rows.append(smoothness_row(run, found))
    body = paragraphs(
        prose(
            "For each carried line and each fibre, the largest change of its length",
            "from frame to frame is divided by the median change over the motion; the",
            f"target is {JUMP:g}. Where the largest change is below",
            f"{SMALL_CHANGE:g} mm the ratio says nothing, and the line counts as",
            "smooth.",
        ),
        commands([run.command for run in runs]),
        table(head, cells),
    )
    return Section("Smoothness of lengths", body, rows)
