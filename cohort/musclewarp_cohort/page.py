# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The page of a group: who failed and why, distributions, and links to the pages
of the subjects. It needs no network, and nothing beside it but those pages."""
import math

from . import comparison, plots
from .markup import escape, number, table

# The page has no script, and loads nothing.
POLICY = ("default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; "
          "form-action 'none'")

STYLE = """
:root { color-scheme: light dark; --line: #8888; --good: #2a78b8; --bad: #c0392b; }
body { font: 15px/1.45 system-ui, sans-serif; margin: 2rem auto; max-width: 72rem;
  padding: 0 1rem; }
h1 { font-size: 1.5rem } h2 { font-size: 1.15rem; margin-top: 2rem }
h3 { font-size: 1rem; margin: 1.5rem 0 .5rem; overflow-wrap: anywhere }
.scroll { overflow-x: auto }
table { border-collapse: collapse; width: 100% }
th, td { border-bottom: 1px solid var(--line); padding: .25rem .6rem .25rem 0;
  text-align: left; vertical-align: top; overflow-wrap: anywhere; min-width: 5.5rem }
td.number, th.number { text-align: right; min-width: 3.5rem }
.bad { color: var(--bad); font-weight: 600 }
.plots { display: grid; gap: 1rem;
  grid-template-columns: repeat(auto-fill, minmax(min(20rem, 100%), 1fr)) }
figure { margin: 0; min-width: 0 } figure p { margin: 0; font-size: .85rem }
figcaption { font-weight: 600; overflow-wrap: anywhere }
svg { width: 100%; height: auto; font: 11px system-ui, sans-serif }
svg text { fill: currentColor } svg .axis { stroke: var(--line) }
svg .bar { fill: var(--good) }
svg polyline { fill: none; stroke: var(--good); stroke-opacity: .5 }
svg .dot { fill: var(--good); fill-opacity: .6 }
svg .band { fill: var(--good); fill-opacity: .3 }
svg polyline.median { stroke: currentColor; stroke-opacity: .8; stroke-width: 1.5 }
svg polyline.out { stroke: var(--bad); stroke-opacity: 1; stroke-width: 2;
  stroke-dasharray: 6 2 }
svg .dot.out { fill: var(--bad); fill-opacity: 1 }
@media (prefers-color-scheme: dark) { :root { --good: #5aa9e6; --bad: #ff7f6e } }
"""


def _runs(rows):
    """The rows of each run."""
    runs = {}
    for row in rows:
        runs.setdefault((row.participant_id, row.motion), []).append(row)
    return list(runs.values())


def _name(row, out):
    text = escape(row.participant_id) + " " + escape(row.motion)
    page = f"{row.participant_id}/{row.motion}/report.html"
    if not (out / page).exists():
        return text
    return f'<a href="{escape(page)}">{text}</a>'


def _failures(runs, out):
    bad = [run[0] for run in runs if run[0].status != "usable"]
    if not bad:
        return "<p>All are usable.</p>"
    heads = ["subject, motion", "how it ended", ("exit code", "number"), "why"]
    return table(heads, (
        [_name(row, out), f'<span class="bad">{escape(row.status)}</span>',
         "" if row.exit_code is None else row.exit_code, escape(row.reason or "")]
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
            _name(row, out), escape(row.status),
            "" if row.frames is None else f"{row.usable_frames} of {row.frames}",
            len(muscles) or "",
            sum(each.crossings for each in muscles) if muscles else "",
            number(_extreme(max, (each.max_volume_error for each in run))),
            number(_extreme(min, (each.least_gap_mm for each in run))),
            number(row.prepare_s), number(row.frames_s), number(row.memory_mb, 4)])
    return table(heads, lines)


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


def as_html(rows, out, measured=()):
    """The page as text; `out` is the folder in which it will be, `measured` what
    the runs say of their muscles (curves.Measured)."""
    runs = _runs(rows)
    usable = sum(run[0].status == "usable" for run in runs)
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{POLICY}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{usable} of {len(runs)} usable</title><style>{STYLE}</style></head><body>
<h1>{usable} of {len(runs)} runs usable</h1>
<p>A run is a subject in a motion; its name leads to its page. All figures of
every muscle are in <a href="group.tsv">group.tsv</a>.</p>
<h2>Not usable</h2>
{_failures(runs, out)}
<h2>Distributions</h2>
<div class="plots">{_distributions(rows, runs)}</div>
{comparison.as_html(measured)}
<h2>All runs</h2>
{_all(runs, out)}
</body></html>
"""
