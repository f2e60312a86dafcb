# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""What musclewarp-cohort does once its command line is read."""
import json
import sys

from . import engine, flags, group, job, table
from .input_error import InputError

MOST_NAMED = 20  # of those that are not usable


def _summary(jobs, out):
    """Prints how the jobs ended, and returns whether all are usable."""
    ended = [(each, group.ending_of(each, out)) for each in jobs]
    bad = [(each, row) for each, row in ended if row.status != group.STATUS[0]]
    for each, row in bad[:MOST_NAMED]:
        log = out / each.folder / job.LOG
        print(f"{each.title}: {row.status}: {row.reason}")
        print(f"  see {log}" if log.exists() else "  has not said anything")
    if len(bad) > MOST_NAMED:
        print(f"... and {len(bad) - MOST_NAMED} more")
    print(f"{len(ended)} jobs in {out}: {len(ended) - len(bad)} usable, "
          f"{len(bad)} not")
    return not bad


def _functions(runs, out):
    """Prints what has become of the functions of divided runs, and returns whether
    all are there and within their bounds."""
    all_good = True
    for run in runs:
        file = out / run.folder / engine.FUNCTIONS
        log = file.with_name(engine.FUNCTIONS_LOG)
        fit = json.loads(file.read_text(encoding="utf-8")) if file.exists() else None
        if fit and fit["within_bounds"]:
            print(f"{run.title}: {len(fit['muscles'])} functions in {file}")
            continue
        all_good = False
        what = "functions miss their bounds" if fit else "no functions"
        why = f"see {log}" if log.exists() else "its parts are not done"
        print(f"{run.title}: {what}; {why}")
    return all_good


def _do(options, beside):
    source, out = options.input.absolute(), options.output.absolute()
    if not source.is_dir():
        raise InputError(f"{source}: is not a folder; IN is the folder with "
                         f"{table.TABLE}")
    if out == source:
        raise InputError(f"{out}: IN and OUT are the same folder; name another "
                         "folder for OUT")
    program = engine.find_deform(options.deform, beside)
    runs = table.read_jobs(source, flags.of_program(program))
    if options.participant_label:
        runs = table.choose(runs, options.participant_label)
    divided = [run for run in runs if run.parts]
    jobs = [part for run in runs for part in run.divided()]
    participants = list(dict.fromkeys(run.participant for run in runs))
    settings = {"input": str(source),
                "program": program,
                "export": divided and engine.find_export(program),
                "participants": participants if options.participant_label else []}
    snakemake = engine.Engine(out, settings, engine.find_profile(options.profile),
                              options.cores, options.dry_run)

    # Records of jobs that ended, however they did; failed ones have a reason.
    code = snakemake.run_jobs(jobs, divided)
    if options.dry_run:
        return code and 1
    if options.level == "group" and not snakemake.interrupted:
        code = snakemake.gather() or code
    all_usable = _summary(jobs, out)
    all_fitted = _functions(divided, out)
    if snakemake.interrupted:
        print("interrupted; run the same command again to go on")
    return 0 if all_usable and all_fitted and code == 0 else 1


def run(options, beside):
    """Returns the exit code."""
    try:
        return _do(options, beside)
    except InputError as error:
        for line in str(error).split("\n"):
            print(f"musclewarp-cohort: {line}", file=sys.stderr)
        return 2
