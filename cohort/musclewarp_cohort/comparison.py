# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The part of the page that compares muscles over subjects: a small plot for each
quantity, and a table of the subjects that are far from the others."""
import dataclasses

from . import curves, outliers, plots
from .markup import escape, number, table

MOST_NAMED = 20  # subjects in a sentence
MOST_ROWS = 300  # of the table of outliers
AT_REST = "at rest"


@dataclasses.dataclass
class Compared:
    """A quantity in the runs of a motion."""

    quantity: curves.Quantity
    curves: dict  # {participant: sorted list of (place, value)}
    outliers: list
    runs: int  # that could have it


def _names(participants):
    """Some of them by name, and how many more there are."""
    named = ", ".join(escape(name) for name in participants[:MOST_NAMED])
    more = len(participants) - MOST_NAMED
    return named + (f" and {more} more" if more > 0 else "")


def compare(runs, axis):
    """Every quantity that a run has, as Compared, in the order of muscles. Volumes
    are curves of one place, 0."""
    found = {}
    for run in runs:
        for quantity, value in run.volumes.items():
            found.setdefault(quantity, {})[run.participant] = [(0, value)]
        for quantity in run.curves:
            found.setdefault(quantity, {})[run.participant] = curves.points(
                run, quantity, axis)
    order = {name: place for place, name in enumerate(dict.fromkeys(
        muscle for run in runs for muscle in run.muscles))}
    kinds = (curves.VOLUME, curves.LENGTH, curves.MOMENT_ARM)
    return [Compared(quantity, found[quantity],
                     outliers.find(found[quantity], _interpolates(axis)), len(runs))
            for quantity in sorted(found, key=lambda each: (
                order.get(each.muscle, len(order)), kinds.index(each.kind), each))]


def _interpolates(axis):
    return not axis.is_frame


def _plot(compared, axis):
    quantity = compared.quantity
    bad = [each.name for each in compared.outliers]
    caption = f"{quantity.title()}, {quantity.unit}"
    if len(compared.curves) < compared.runs:
        caption += f" ({len(compared.curves)} of {compared.runs} runs)"
    if quantity.kind == curves.VOLUME:
        drawing = plots.dots({name: curve[0][1]
                              for name, curve in compared.curves.items()}, bad)
    else:
        drawing = plots.curves(compared.curves, bad, axis.label(),
                               _interpolates(axis))
    note = f'<p class="bad">{_names(bad)}</p>' if bad else ""
    return plots.figure(caption, drawing + note)


def _missing(runs, muscle):
    """A sentence about the runs that lack a muscle."""
    lack = [run.participant for run in runs if muscle not in run.muscles]
    if not lack:
        return ""
    return (f"<p>{len(runs) - len(lack)} of {len(runs)} runs have it; "
            f"{len(lack)} {'lacks' if len(lack) == 1 else 'lack'} it: "
            f"{_names(lack)}.</p>")


def _muscles(runs, compared, axis):
    by_muscle = {}
    for each in compared:
        by_muscle.setdefault(each.quantity.muscle, []).append(each)
    return "\n".join(
        f"<h3>{escape(muscle)}</h3>{_missing(runs, muscle)}"
        '<div class="plots">' + "\n".join(_plot(each, axis) for each in drawn) +
        "</div>" for muscle, drawn in by_muscle.items())


def _where(quantity, place, axis):
    if quantity.kind == curves.VOLUME:
        return AT_REST
    return f"{escape(axis.name)} {place:.4g} {escape(axis.unit)}".strip()


def _outliers(compared, axis, runs):
    """The table, or a sentence if there is nothing to list."""
    if len(runs) < outliers.FEWEST:
        return (f"<p>No outliers are sought among {len(runs)} runs; it takes "
                f"{outliers.FEWEST}.</p>")
    found = [(outlier, each.quantity) for each in compared
             for outlier in each.outliers]
    sought = [each for each in compared if len(each.curves) >= outliers.FEWEST]
    said = (f"{len(sought)} of {len(compared)} quantities are there in at least "
            f"{outliers.FEWEST} runs.")
    if not found:
        return f"<p>No outliers. {said}</p>"
    found.sort(key=lambda pair: (pair[0].name, -pair[0].excess))
    subjects = len({outlier.name for outlier, _ in found})
    heads = ["subject", "muscle", "quantity", "where", ("value", "number"),
             ("group's median", "number"), "unit"]
    rows = [[f'<span class="bad">{escape(outlier.name)}</span>',
             escape(quantity.muscle), escape(quantity.title()),
             _where(quantity, outlier.place, axis), number(outlier.value, 4),
             number(outlier.median, 4), escape(quantity.unit)]
            for outlier, quantity in found[:MOST_ROWS]]
    more = len(found) - len(rows)
    return (f"<p>Subjects with outliers: {subjects}; outliers: {len(found)}, each "
            f"listed where it is farthest out. {said}"
            + (f" The first {MOST_ROWS} are listed." if more > 0 else "") + "</p>"
            + table(heads, rows))


def _motion(motion, all_runs):
    runs = [run for run in all_runs if run.frames]
    lost = [run.participant for run in all_runs if not run.frames]
    said = f"{len(runs)} of {len(all_runs)} runs are compared."
    if lost:
        said += (f" {len(lost)} {'has' if len(lost) == 1 else 'have'} no usable "
                 f"frames: {_names(lost)}.")
    heading = f"<h2>Muscles over subjects: {escape(motion)}</h2><p>{said}</p>"
    if not runs:
        return heading
    axis = curves.axis_of(runs)
    compared = compare(runs, axis)
    over = ("frames, since it is not one coordinate alone that moves, in one "
            "direction, in every run" if axis.is_frame else axis.name)
    return (f"{heading}<p>Curves are over {escape(over)}.</p>"
            f"{_outliers(compared, axis, runs)}\n{_muscles(runs, compared, axis)}")


def as_html(measured):
    """The comparison of runs (curves.Measured), motion by motion; "" if no run has
    a usable frame."""
    if not any(run.frames for run in measured):
        return ""
    motions = {}
    for run in measured:
        motions.setdefault(run.motion, []).append(run)
    drawn = "\n".join(_motion(motion, runs) for motion, runs in motions.items())
    return (f"{drawn}\n<h3>How outliers are found</h3><p>{escape(outliers.RULE)} "
            "Only usable frames count, of every run as far as it came; volumes are "
            "those of meshes at rest. Dots and curves in red are outliers, and the "
            f"dark curve is the group's median. Of more than {plots.MOST_CURVES} "
            "runs the range is drawn in place of their curves.</p>")
