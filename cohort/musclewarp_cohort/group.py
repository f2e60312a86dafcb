# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Gathers what the jobs wrote, as OUT/group.tsv and OUT/group.html.

usage: python3 -m musclewarp_cohort.group --input=IN --output=OUT [PARTICIPANT...]
"""
import argparse
import dataclasses
import json
import pathlib
import sys
from typing import Optional

from . import curves
from . import job as jobs
from . import page, table
from .files import write_atomically

STATUS = {0: "usable", 1: "not usable", 2: "refused"}
NOT_FINISHED = "not finished"
FROM_GOOD_TO_BAD = (*STATUS.values(), NOT_FINISHED)


@dataclasses.dataclass
class Row:
    """A muscle of a subject in a motion; the fields are the columns of
    group.tsv. Of a run without results there is one row, without a muscle."""

    participant_id: str
    motion: str
    muscle: Optional[str] = None
    status: str = NOT_FINISHED
    exit_code: Optional[int] = None
    frames: Optional[int] = None  # that are there, of the run
    usable_frames: Optional[int] = None
    crossings: Optional[int] = None  # sum over the frames
    max_volume_error: Optional[float] = None
    least_gap_mm: Optional[float] = None  # None: farther than 2 mm from all
    # {(line, coordinate): (smallest, largest)}
    moment_arms_mm: dict = dataclasses.field(default_factory=dict)
    prepare_s: Optional[float] = None
    frames_s: Optional[float] = None
    memory_mb: Optional[float] = None
    reason: Optional[str] = None


def _crossings(frame, muscle):
    """Of a muscle with others, bones and itself."""
    own = next(m for m in frame["muscles"] if m["name"] == muscle)
    return own.get("self_pairs", 0) + sum(
        pair["triangle_pairs"] + pair["vertices_inside"]
        for pair in frame["intersections"]["pairs"]
        if muscle in (pair["a"], pair["b"]))


def _volume_error(muscle):
    """By how much the solver missed the volume; earlier reports had the ratio."""
    return muscle.get("volume_error", muscle["volume_ratio"] - 1)


def _moment_arms(muscles):
    """The range of each moment arm over the frames."""
    ranges = {}
    for muscle in muscles:
        for line, arms in muscle.get("line_moment_arms_mm", {}).items():
            for coordinate, arm in arms.items():
                if arm is None:  # the shape could not be differentiated
                    continue
                least, most = ranges.get((line, coordinate), (arm, arm))
                ranges[line, coordinate] = min(least, arm), max(most, arm)
    return ranges


def _of_muscle(row, report, name):
    """The row of a run, with what its frames say of a muscle."""
    frames = report["frames"]
    muscles = [muscle for frame in frames for muscle in frame["muscles"]
               if muscle["name"] == name]
    gaps = [gap["at_least_mm"] for frame in frames
            for gap in frame.get("gaps", []) if name in (gap["a"], gap["b"])]
    return dataclasses.replace(
        row, muscle=name,
        crossings=sum(_crossings(frame, name) for frame in frames),
        max_volume_error=max((abs(_volume_error(muscle))
                              for muscle in muscles), default=None),
        least_gap_mm=min(gaps, default=None),
        moment_arms_mm=_moment_arms(muscles))


def _read(file):
    try:
        return json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None


def _with_figures(row, report):
    """The rows of a run with a report, one for each muscle."""
    prepare, frames = report["prepare"], report["frames"]
    row = dataclasses.replace(
        row, frames=len(frames),
        usable_frames=sum(frame["usable"] for frame in frames),
        prepare_s=(prepare["wall_ms"] + prepare.get("contact_ms", 0)) / 1000,
        frames_s=sum(frame["wall_ms"] for frame in frames) / 1000)
    return [_of_muscle(row, report, muscle["name"])
            for muscle in prepare["muscles"]]


def read_run(job, out):
    """(rows, curves.Measured) of a job, as far as it came."""
    report = _report_of(job, out)
    rows = _rows_of(job, out, report)
    return rows, curves.of_report(job.participant, job.motion,
                                  report if rows[0].frames else None)


def _report_of(job, out):
    """The report of a run, as far as it came; that of a divided run has the frames
    and times of all its parts. None if there is none."""
    reports = [_read(out / part.folder / jobs.REPORT) for part in job.divided()]
    reports = [report for report in reports if report]
    if len(reports) < 2:
        return reports[0] if reports else None
    whole = dict(reports[0])
    try:
        prepares = [report["prepare"] for report in reports]
        times = {key: sum(prepare.get(key, 0) for prepare in prepares)
                 for key in ("wall_ms", "contact_ms")}
        whole["prepare"] = {**prepares[0], **times}
        whole["frames"] = [frame for report in reports for frame in report["frames"]]
    except (LookupError, TypeError, AttributeError):
        return None  # one of them is no report
    return whole


def ending_of(job, out):
    """The row of a job that says how it ended, without figures; of a divided run
    the worst of its parts."""
    if not job.part and job.parts:
        return _ending_of_parts(job, out)
    folder = out / job.folder
    record = _read(folder / jobs.RECORD)
    row = Row(job.participant, job.motion)
    if record:
        row.status = STATUS[record["exit_code"]]
        row.exit_code = record["exit_code"]
        row.memory_mb = record["memory_mb"]
        row.reason = record["reason"] or None
    else:
        said = jobs.last_line(folder / jobs.LOG)
        row.reason = (said.removeprefix("musclewarp-cohort: ") if said
                      else "did not start; run again")
    return row


def _ending_of_parts(job, out):
    parts = job.divided()
    endings = [ending_of(part, out) for part in parts]
    bad = [index for index, row in enumerate(endings)
           if row.status != FROM_GOOD_TO_BAD[0]]
    worst = max(range(job.parts), key=lambda index: FROM_GOOD_TO_BAD.index(
        endings[index].status))
    row = dataclasses.replace(endings[worst], memory_mb=max(
        (each.memory_mb for each in endings if each.memory_mb), default=None))
    if bad:
        row.reason = (f"{len(bad)} of {job.parts} parts, such as "
                      f"{parts[worst].part}: {row.reason}")
    return row


def _rows_of(job, out, report):
    """The rows of a run, as far as it came; `report` is that of the run."""
    row = ending_of(job, out)
    if not report or row.exit_code == 2:
        return [row]
    try:
        return _with_figures(row, report)
    except (LookupError, TypeError, AttributeError):
        if row.exit_code is not None:
            raise
        return [row]  # what is no report has no figures


def _field(value):
    if value is None or value == {}:
        return table.EMPTY
    if isinstance(value, dict):
        return ";".join(f"{line}.{coordinate}={least:.4g}:{most:.4g}"
                        for (line, coordinate), (least, most) in value.items())
    if isinstance(value, float):
        return f"{value:.6g}"
    return " ".join(str(value).split())  # no tabs or line breaks


def as_tsv(rows):
    names = [field.name for field in dataclasses.fields(Row)]
    lines = ["\t".join(names)]
    lines += ["\t".join(_field(getattr(row, name)) for name in names)
              for row in rows]
    return "\n".join(lines) + "\n"


def chosen_jobs(source, participants):
    return [job for job in table.read_jobs(source)
            if not participants or job.participant in participants]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--input", required=True, type=pathlib.Path)
    parser.add_argument("--output", required=True, type=pathlib.Path)
    parser.add_argument("participants", nargs="*")
    options = parser.parse_args()
    runs = [read_run(job, options.output)
            for job in chosen_jobs(options.input, set(options.participants))]
    rows = [row for rows, _ in runs for row in rows]
    write_atomically(options.output / "group.tsv", as_tsv(rows))
    write_atomically(options.output / "group.html",
                     page.as_html(rows, options.output,
                                  [measured for _, measured in runs]))
    return 0


if __name__ == "__main__":
    sys.exit(main())
