# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of a group: who failed and why, distributions, and links to the pages
of the subjects. It needs no network, and nothing beside it but those pages."""
import html
import math

from . import plots

STYLE = """
:root { color-scheme: light dark; --line: #8888; --good: #2a78b8; --bad: #c0392b; }
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem auto; max-width: 72rem;
  padding: 0 1rem; }
h1 { font-size: 1.5rem } h2 { font-size: 1.15rem; margin-top: 2rem }
table { border-collapse: collapse; width: 100% }
th, td { border-bottom: 1px solid var(--line); padding: .25rem .6rem .25rem 0;
  text-align: left; vertical-align: top; overflow-wrap: anywhere }
td.number, th.number { text-align: right; white-space: nowrap }
.bad { color: var(--bad); font-weight: 600 }
.plots { display: grid; gap: 1rem;
  grid-template-columns: repeat(auto-fill, minmax(20rem, 1fr)) }
figure { margin: 0 } figcaption { font-weight: 600 }
svg { width: 100%; height: auto; font: 11px system-ui, sans-serif }
svg text { fill: currentColor } svg .axis { stroke: var(--line) }
svg .bar { fill: var(--good) }
svg .range { stroke: var(--good); stroke-width: 2; stroke-opacity: .45 }
"""


def _escape(value):
    return html.escape(str(value))


def _number(value, digits=3):
    return "" if value is None else f"{value:.{digits}g}"


def _table(heads, rows):
    """`heads` are names, or (name, class); cells are HTML."""
    heads = [head if isinstance(head, tuple) else (head, "") for head in heads]
    lines = ["<table><thead><tr>"]
    lines += [f'<th class="{kind}">{_escape(name)}</th>' for name, kind in heads]
    lines.append("</tr></thead><tbody>")
    for row in rows:
        lines.append("<tr>" + "".join(
            f'<td class="{kind}">{cell}</td>'
            for cell, (_, kind) in zip(row, heads)) + "</tr>")
    return "\n".join(lines + ["</tbody></table>"])


def _runs(rows):
    """The rows of each run."""
    runs = {}
    for row in rows:
        runs.setdefault((row.participant_id, row.motion), []).append(row)
    return list(runs.values())


def _name(row, out):
    text = _escape(row.participant_id) + " " + _escape(row.motion)
    page = f"{row.participant_id}/{row.motion}/report.html"
    if not (out / page).exists():
        return text
    return f'<a href="{_escape(page)}">{text}</a>'


def _failures(runs, out):
    bad = [run[0] for run in runs if run[0].status != "usable"]
    if not bad:
        return "<p>All are usable.</p>"
    heads = ["subject, motion", "how it ended", ("exit code", "number"), "why"]
    return _table(heads, (
        [_name(row, out), f'<span class="bad">{_escape(row.status)}</span>',
         "" if row.exit_code is None else row.exit_code, _escape(row.reason or "")]
        for row in bad))


def _all(runs, out):
    heads = ["subject, motion", "how it ended"] + [(name, "number") for name in (
        "usable frames", "muscles", "crossings", "volume error", "least gap, mm",
        "preparation, s", "frames, s", "memory, MB")]
    lines = []
    for run in runs:
        row = run[0]
        muscles = [each for each in run if each.muscle is not None]
        lines.append([
            _name(row, out), _escape(row.status),
            "" if row.frames is None else f"{row.usable_frames} of {row.frames}",
            len(muscles) or "",
            sum(each.crossings for each in muscles) if muscles else "",
            _number(_extreme(max, (each.max_volume_error for each in run))),
            _number(_extreme(min, (each.least_gap_mm for each in run))),
            _number(row.prepare_s), _number(row.frames_s), _number(row.memory_mb, 4)])
    return _table(heads, lines)


def _extreme(choose, values):
    return choose((value for value in values if value is not None), default=None)


def _distributions(rows, runs):
    firsts = [run[0] for run in runs]

    def seconds(row):
        return None if row.frames_s is None else row.prepare_s + row.frames_s

    drawn = [
        ("Time of a job, s", [seconds(row) for row in firsts]),
        ("Memory of a job, MB", [row.memory_mb for row in firsts if row.frames]),
        ("Usable frames of a job, %",
         [100 * row.usable_frames / row.frames for row in firsts if row.frames]),
        ("Largest volume error of a muscle, power of 10",
         [math.log10(row.max_volume_error) for row in rows if row.max_volume_error]),
        ("Least gap of a muscle, mm", [row.least_gap_mm for row in rows]),
    ]
    return "\n".join(plots.figure(title, plots.histogram(values))
                     for title, values in drawn)


def _moment_arms(rows):
    """A strip for each line and coordinate, with the range of each run."""
    ranges = {}
    for row in rows:
        for (line, coordinate), span in row.moment_arms_mm.items():
            ranges.setdefault((row.muscle, line, coordinate), []).append(
                (span, f"{row.participant_id} {row.motion}"))
    if not ranges:
        return ""
    drawn = "\n".join(
        plots.figure(f"{line}, {coordinate}", plots.strip(spans))
        for (_, line, coordinate), spans in sorted(ranges.items()))
    return ("<h2>Moment arms, mm (mm/m of translations)</h2>"
            "<p>Smallest to largest over the frames, a line for each run.</p>"
            f'<div class="plots">{drawn}</div>')


def as_html(rows, out):
    """The page as text; `out` is the folder in which it will be."""
    runs = _runs(rows)
    usable = sum(run[0].status == "usable" for run in runs)
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{usable} of {len(runs)} usable</title><style>{STYLE}</style></head><body>
<h1>{usable} of {len(runs)} runs usable</h1>
<p>A run is a subject in a motion; its name leads to its page. All figures of
every muscle are in <a href="group.tsv">group.tsv</a>.</p>
<h2>Not usable</h2>
{_failures(runs, out)}
<h2>Distributions</h2>
<div class="plots">{_distributions(rows, runs)}</div>
{_moment_arms(rows)}
<h2>All runs</h2>
{_all(runs, out)}
</body></html>
"""
