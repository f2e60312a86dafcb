#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes the page of a group in which texts stand wherever names and reasons do.

usage: write_group_page.py PAGE MUSCLE REASON LINE
"""
import json
import pathlib
import sys
import tempfile

from folder import frame, report
from musclewarp_cohort import group, page
from musclewarp_cohort.table import Job


def main():
    file, muscle, reason, line = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        out = pathlib.Path(name)
        jobs = [Job(f"sub-{number}", "scene", "s.json") for number in (1, 2, 3)]
        for number, job in enumerate(jobs):
            folder = out / job.participant / "scene"
            folder.mkdir(parents=True)
            arms = {line: {reason: 30.0 + number}}
            (folder / "report.json").write_text(json.dumps(
                report([frame(index, [(muscle, 1.0, arms)]) for index in (0, 1)])))
            (folder / "job.json").write_text(json.dumps(
                {"exit_code": 2 * (number == 0), "reason": reason, "wall_s": 1,
                 "memory_mb": 70}))
        rows = [row for job in jobs for row in group.read_run(job, out)[0]]
        measured = [group.read_run(job, out)[1] for job in jobs]
        pathlib.Path(file).write_text(page.as_html(rows, out, measured))


if __name__ == "__main__":
    main()
