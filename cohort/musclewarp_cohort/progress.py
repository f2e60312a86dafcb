# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Says on the screen how far a cohort is: what Snakemake says itself goes to a log.

That a job has ended is seen by its record, wherever it ran; how many there are to
do, and which were killed, by the log of Snakemake 7 or 8."""
import re

from . import group
from . import job as jobs

RULE = "deform"  # of the Snakefile, by which jobs are known in the log
LAST_LINES = 3  # of the log, where Snakemake itself has failed


class SnakemakeLog:
    """What Snakemake has written to its log since this was made."""

    def __init__(self, path):
        self.planned = None  # jobs to do; None until it has said so
        self.announced = []  # (folder, reason) of jobs that it begins
        self.failed = []  # folders of jobs that left no record
        self.path = path
        self._offset = path.stat().st_size if path.exists() else 0
        self._rest = b""  # of a line that has not ended
        self._kind = None  # of the block that is being read

    def read(self):
        """Takes in what has been written since the last call."""
        with open(self.path, "rb") as file:
            file.seek(self._offset)
            said = file.read()
        self._offset += len(said)
        *lines, self._rest = (self._rest + said).split(b"\n")
        for line in lines:
            self._take(line.decode(errors="replace"))

    def _take(self, line):
        count = re.match(rf"{RULE}\s+(\d+)\b", line)
        if count and self.planned is None:
            self.planned = int(count[1])
        if line and not line[0].isspace():  # where a block begins
            self._kind = {f"rule {RULE}:": "begins",
                          f"Error in rule {RULE}:": "fails"}.get(line)
            return
        field = re.match(r"\s+(output|reason): (.*)", line)
        if field and self._kind:
            self._take_field(*field.groups())

    def _take_field(self, name, value):
        folder = value.partition(f"/{jobs.RECORD}")[0]
        if name == "output" and self._kind == "fails":
            self.failed.append(folder)
        elif name == "output":
            self.announced.append((folder, ""))
        elif self._kind == "begins" and self.announced:
            self.announced[-1] = (self.announced[-1][0], value)


def _stamp(path):
    """What differs once a record has been written anew."""
    try:
        stat = path.stat()
    except OSError:
        return None
    return stat.st_mtime_ns, stat.st_ino


class Progress:
    """Tells of jobs as they end. `log` is the file to which Snakemake writes, `say`
    takes a line for the screen."""

    def __init__(self, all_jobs, out, log, say=lambda line: print(line, flush=True)):
        self._jobs = {each.folder: each for each in all_jobs}
        self._out, self._say = out, say
        self._log = SnakemakeLog(log)
        self._before = {folder: _stamp(self._record(folder)) for folder in self._jobs}
        self._waiting = set(self._jobs)
        self._ended = 0
        self._said_plan = False

    def look(self):
        """Tells of the jobs that have ended since the last look, among those that
        Snakemake has begun: folders may be on a network."""
        self._log.read()
        self._say_plan()
        self._say_ended([folder for folder, _ in self._log.announced])

    def end(self, code, dry_run):
        """Tells the rest, once Snakemake has ended with an exit code."""
        self.look()
        self._say_ended(self._jobs)  # however a Snakemake to come announces them
        if code == 0 and self._jobs and not self._said_plan:
            self._log.planned = 0  # of nothing to do Snakemake makes no plan
            self._say_plan()
        if dry_run:
            self._say_dry_run()
        if code:
            self._say_failure(code)

    def _record(self, folder):
        return self._out / folder / jobs.RECORD

    def _has_ended(self, folder):
        now = _stamp(self._record(folder))
        return (now is not None and now != self._before[folder]
                or folder in self._log.failed)

    def _say_ended(self, folders):
        for folder in folders:
            if folder in self._waiting and self._has_ended(folder):
                self._waiting.discard(folder)
                self._ended += 1
                self._say_end(self._jobs[folder])

    def _say_plan(self):
        planned = self._log.planned
        if self._said_plan or planned is None:
            return
        self._said_plan = True
        self._say(f"{planned} of {len(self._jobs)} jobs to do; what Snakemake says: "
                  f"{self._log.path}")

    def _say_end(self, job):
        planned = self._log.planned or len(self._jobs)
        ended = group.ending_of(job, self._out)
        line = f"[{self._ended} of {planned}] {job.title}: {ended.status}"
        if ended.status != group.STATUS[0]:
            line += f": {ended.reason}; see {self._out / job.folder / jobs.LOG}"
        self._say(line)

    def _say_dry_run(self):
        for folder, reason in self._log.announced:
            if folder in self._jobs:
                job = self._jobs[folder]
                self._say(f"would run {job.title}"
                          + (f" ({reason})" if reason else ""))

    def _say_failure(self, code):
        path = self._log.path
        self._say(f"Snakemake ended with exit code {code}; what it said is in {path}")
        if self._log.failed:
            return
        said = path.read_text(encoding="utf-8", errors="replace").splitlines()
        for line in [line for line in said if line.strip()][-LAST_LINES:]:
            self._say(f"  {line.strip()}")
