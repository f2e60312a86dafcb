#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes the generated chapters of docs/performance.md and their plots; called by
benchmarks/performance.sh, which measures the figures.

  benchmarks/performance/page.py FIGURES PAGE [--source=docs/performance.md]
      [--command=TEXT]

A chapter goes between its two markers; all else of the source stays as it is.
The chapter of steps is left as it is without FIGURES/steps.md. Plots are in the
folder of the name of PAGE. Needs the python3-numpy of Debian.
"""

import argparse
import os
import pathlib
import sys
import tempfile

import growth
import modes
import shared  # noqa: F401, where table is
import stages
from chapters import markers, replaced
from figures import load_of, machine_of
from table import prose

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]


# Above this share of the processors for other programs, figures are not to be used.
MAX_LOAD = 0.05
BUSY = (
    "**The machine was busy: times and ratios, of two threads to one above all, are "
    "those of what was left of it and not of the program.**"
)


def of_another_build(text, code):
    """Whether the chapter of steps, which is not always made, has other code."""
    begin, end = markers("Steps")
    return code not in text.split(begin)[1].split(end)[0]


def head(command, processor, code, load):
    return [
        f"    {command}",
        prose(
            "measures what the chapters between markers report, on a machine that does",
            f"nothing else. The processor is {processor}, the code (`code` of",
            f"[report.json](report.md)) `{code}`. Other programs took {100 * load:.0f} %",
            "of the processors meanwhile.",
            BUSY if load > MAX_LOAD else "",
        ),
    ]


def chapters_of(figures, plots, command):
    """The parts of each chapter by its name."""
    chapters = {
        "Machine": head(command, *machine_of(figures), load_of(figures)),
        "Stages": stages.chapter(figures),
        "Modes": modes.chapter(figures),
        "Growth": growth.chapter(figures, plots),
    }
    steps = figures / "steps.md"
    if steps.exists():
        chapters["Steps"] = [steps.read_text().strip()]
    return chapters


def write_page(figures, source, page, command):
    """Writes page and plots; none of them if a figure is missing."""
    plots = page.parent / page.stem
    page.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=page.parent) as folder:
        made = pathlib.Path(folder)
        made_plots = made / plots.name
        made_plots.mkdir()
        text = source.read_text(encoding="utf-8")
        for name, parts in chapters_of(figures, made_plots, command).items():
            text = replaced(text, name, parts)
        if of_another_build(text, machine_of(figures)[1]):
            print("performance: steps are of another build; --steps makes them again")
        if load_of(figures) > MAX_LOAD:
            print("performance: the machine was busy with other programs; measure again")
        (made / page.name).write_text(text, encoding="utf-8")
        plots.mkdir(exist_ok=True)
        for plot in made_plots.iterdir():
            os.replace(plot, plots / plot.name)
        os.replace(made / page.name, page)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("figures", type=pathlib.Path)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument(
        "--source", type=pathlib.Path, default=REPOSITORY / "docs/performance.md"
    )
    parser.add_argument("--command", default="benchmarks/performance.sh DATA OUT")
    args = parser.parse_args()
    try:
        write_page(args.figures, args.source, args.page.resolve(), args.command)
    except (ValueError, KeyError, OSError) as error:
        print(f"performance: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
