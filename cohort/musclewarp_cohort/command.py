# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""What musclewarp-cohort does once its command line is read."""
import sys

from . import engine, flags, group, job, table
from .input_error import InputError

MOST_NAMED = 20  # of those that are not usable


def _summary(rows, out):
    """Prints how the jobs ended, and returns whether all are usable."""
    ended = {(row.participant_id, row.motion): row for row in rows}
    bad = [row for row in ended.values() if row.status != group.STATUS[0]]
    for row in bad[:MOST_NAMED]:
        log = out / row.participant_id / row.motion / job.LOG
        print(f"{row.participant_id} {row.motion}: {row.status}: {row.reason}")
        print(f"  see {log}" if log.exists() else "  has not said anything")
    if len(bad) > MOST_NAMED:
        print(f"... and {len(bad) - MOST_NAMED} more")
    print(f"{len(ended)} jobs in {out}: {len(ended) - len(bad)} usable, "
          f"{len(bad)} not")
    return not bad


def _do(options, beside):
    source, out = options.input.absolute(), options.output.absolute()
    if not source.is_dir():
        raise InputError(f"{source}: is not a folder; IN is the folder with "
                         f"{table.TABLE}")
    if out == source:
        raise InputError(f"{out}: IN and OUT are the same folder; name another "
                         "folder for OUT")
    program = engine.find_program(options.deform, beside)
    jobs = table.read_jobs(source, flags.of_program(program))
    if options.participant_label:
        jobs = table.choose(jobs, options.participant_label)
    participants = list(dict.fromkeys(job.participant for job in jobs))
    settings = {"input": str(source),
                "program": program,
                "participants": participants if options.participant_label else []}
    snakemake = engine.Engine(out, settings, engine.find_profile(options.profile),
                              options.cores, options.dry_run)

    # Records of jobs that ended, however they did; failed ones have a reason.
    code = snakemake.run_jobs(jobs)
    if options.dry_run:
        return code and 1
    if options.level == "group" and not snakemake.interrupted:
        code = snakemake.gather() or code
    rows = [row for each in jobs for row in group.rows_of(each, out)]
    all_usable = _summary(rows, out)
    if snakemake.interrupted:
        print("interrupted; run the same command again to go on")
    return 0 if all_usable and code == 0 else 1


def run(options, beside):
    """Returns the exit code."""
    try:
        return _do(options, beside)
    except InputError as error:
        for line in str(error).split("\n"):
            print(f"musclewarp-cohort: {line}", file=sys.stderr)
        return 2
