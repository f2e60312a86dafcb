# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs musclewarp-deform --resume for one subject and motion, or part of it.

usage: python3 -m musclewarp_cohort.job --folder=DIR --program=FILE --threads=N JOB

JOB is JSON (table.Job). The folder gets what musclewarp-deform writes, job.log
with what it says and, once it has come to its end, job.json: "exit_code" (0
usable, 1 not usable, 2 refused), "reason", "wall_s", "cpu_s", "memory_mb".

Only a report.json of this run says how it ended: one that it has written, or one
of which musclewarp-deform says that it is of the same input.

Exit code: 0 if job.json was written, however the run ended. 1 if the run did not
come to its end, because it was killed or interrupted or the disk is full, or if
its exit code is 0 and no report bears it out: to be run again, it goes on where
it stopped.
"""
import argparse
import dataclasses
import hashlib
import json
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time

from .files import locked, write_atomically
from .table import Job, input_files

LOCK, LOG, RECORD = ".lock", "job.log", "job.json"
INPUTS, REPORT = ".inputs", "report.json"
# What musclewarp-deform --resume says, before the name of the report, where it has
# found that the report is of the same input and finished.
FINISHED_ALREADY = "finished already: "


def _scene_of(job, folder):
    """The scene file to run: the job's, or a copy in which model and side are
    those of the table."""
    changes = {"model": job.model, "side": job.side}
    changes = {key: value for key, value in changes.items() if value}
    if not changes:
        return job.scene
    try:
        scene = json.loads(pathlib.Path(job.scene).read_text(encoding="utf-8"))
        text = json.dumps({**scene, **changes}, indent=2)
    except (ValueError, TypeError):
        return job.scene  # musclewarp-deform says what is wrong with it
    write_atomically(folder / "scene.json", text + "\n")
    return str(folder / "scene.json")


def command(job, folder, program, threads):
    """The command line; flags of the table come after those that they may
    change, such as --nohtml."""
    words = [program, "--html", f"--data_root={job.data_root()}", *job.flags,
             f"--scene={_scene_of(job, folder)}", f"--out={folder}",
             f"--threads={threads}", "--resume"]
    if job.motion_file:
        words.append(f"--motion={job.motion_file}")
    if job.part:
        words.append(f"--frames={job.part}/{job.parts}")
    return words


def _inputs(job, program):
    """A hash of all that results depend on."""
    version = subprocess.run([program, "--version"], capture_output=True,
                             text=True, check=False).stdout
    row = dataclasses.replace(job, line=0)
    hashed = hashlib.sha256(f"{version}\n{row}".encode())
    for file in input_files(job):
        hashed.update(b"\n" + file.encode() + b"\n")
        hashed.update(hashlib.sha256(pathlib.Path(file).read_bytes()).digest())
    return hashed.hexdigest()


def _clear_if_changed(job, folder, program):
    """Removes a run of other input, which --resume would refuse to go on with.
    What has not come from here is left alone."""
    now, mark = _inputs(job, program), folder / INPUTS
    if mark.exists() and mark.read_text(encoding="utf-8") != now:
        for entry in folder.iterdir():
            if entry.name in (LOCK, INPUTS):
                continue
            shutil.rmtree(entry) if entry.is_dir() else entry.unlink()
    write_atomically(mark, now)


def _stamp(file):
    """What differs once a file has been written anew; None if it is not there."""
    try:
        stat = file.stat()
    except OSError:
        return None
    return stat.st_ino, stat.st_mtime_ns, stat.st_size


def _report_of_run(folder, before):
    """report.json, if it is of the run that has ended: `before` is its stamp when
    the run began. None if it is not, or is not there, or is no report."""
    file = folder / REPORT
    if _stamp(file) == before and not any(
            line.startswith(FINISHED_ALREADY) for line in _lines(folder / LOG)):
        return None
    try:
        report = json.loads(file.read_text(encoding="utf-8"))
        is_report = isinstance(report["summary"]["finished"], bool)
    except (OSError, ValueError, TypeError, KeyError):
        return None
    return report if is_report else None


def _why_not_usable(report):
    """What the first frame that is not usable falls short of."""
    frames = report["frames"]
    bad = [frame for frame in frames if not frame["usable"]]
    if not bad:
        return "not usable, with no bad frame in report.json"
    first = bad[0]
    why = "; ".join(first.get("shortcomings") or [first["stop_reason"]])
    return (f"{len(bad)} of {len(frames)} frames not usable, first "
            f"{first['index']} ({first['name']}): {why}")


def _lines(log):
    """The lines that a program said, without what it overwrote."""
    try:
        lines = log.read_text(encoding="utf-8", errors="replace").split("\n")
    except OSError:
        return []
    return [line.strip().rpartition("\r")[2] for line in lines]


def last_line(log):
    """The last line that a program said."""
    return next((line for line in reversed(_lines(log)) if line), "")


def _what_is_missing(report):
    """Why a run with exit code 0 is not usable all the same; "" if it is."""
    if not report:
        return "it wrote no report.json"
    summary = report["summary"]
    if not summary["finished"]:
        return "report.json says that the run is not finished"
    if summary.get("usable") is not True:
        return "report.json does not say that the run is usable"
    return ""


def _outcome(code, folder, report):
    """(whether the run came to its end, the reason if it is not usable); `report`
    is that of the run, or None."""
    if code == 0:
        missing = _what_is_missing(report)
        return not missing, missing and (
            f"musclewarp-deform ended with exit code 0, but {missing}; check the "
            "program that --deform names, and run again")
    if code == 2:
        said = last_line(folder / LOG)
        return True, said.partition("musclewarp-deform: ")[2] or said
    if code == 1 and report and report["summary"]["finished"]:
        return True, _why_not_usable(report)
    if code < 0:
        name = signal.Signals(-code).name
        return False, (f"killed by {name}; run again to go on (SIGKILL: perhaps "
                       "it was out of memory)")
    stopped = report and report["summary"].get("stopped")
    return False, (stopped or last_line(folder / LOG) or
                   f"musclewarp-deform ended with exit code {code}")


def _run(words, log, lock):
    """Runs a program to its end. It gets Ctrl-C itself and SIGTERM from here,
    on which it finishes its frame."""
    child = None
    signal.signal(signal.SIGINT, lambda *_: None)
    signal.signal(signal.SIGTERM,
                  lambda *_: child and child.send_signal(signal.SIGTERM))
    child = subprocess.Popen(words, stdout=log, stderr=subprocess.STDOUT,
                             stdin=subprocess.DEVNULL, pass_fds=[lock])
    return child.wait()


def run(job, folder, program, threads):
    """Runs a job in its folder. Returns the exit code (above)."""
    folder.mkdir(parents=True, exist_ok=True)
    # A run that outlived its engine is waited for, and then found finished.
    with locked(folder / LOCK, wait=True) as lock:
        _clear_if_changed(job, folder, program)
        (folder / RECORD).unlink(missing_ok=True)  # of an earlier run
        before = _stamp(folder / REPORT)
        began = time.monotonic()
        with open(folder / LOG, "w", encoding="utf-8") as log:
            code = _run(command(job, folder, program, threads), log, lock)
        done, reason = _outcome(code, folder, _report_of_run(folder, before))
        if not done:
            with open(folder / LOG, "a", encoding="utf-8") as log:
                log.write(f"\nmusclewarp-cohort: {reason}\n")
            return 1
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        record = {"participant_id": job.participant, "motion": job.motion,
                  "exit_code": code, "reason": reason,
                  "wall_s": round(time.monotonic() - began, 3),
                  "cpu_s": round(used.ru_utime + used.ru_stime, 3),
                  "memory_mb": round(used.ru_maxrss / 1024, 1)}
        write_atomically(folder / RECORD, json.dumps(record, indent=2) + "\n")
        return 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--folder", required=True, type=pathlib.Path)
    parser.add_argument("--program", required=True)
    parser.add_argument("--threads", default="1")
    parser.add_argument("job", type=json.loads)
    options = parser.parse_args()
    row = {**options.job, "flags": tuple(options.job["flags"])}
    return run(Job(**row), options.folder.absolute(), options.program,
               options.threads)


if __name__ == "__main__":
    sys.exit(main())
