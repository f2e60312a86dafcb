# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Calls Snakemake. What it says goes to a log in OUT."""
import json
import os
import pathlib
import shutil
import signal
import subprocess

from .files import locked, write_atomically
from .input_error import InputError
from .job import RECORD
from .progress import Progress

WORKFLOW = pathlib.Path(__file__).resolve().parent.parent
PROFILES = WORKFLOW / "profiles"
SETTINGS = ".cohort.json"  # of the last call; jobs that wait read it, too
LOG = "snakemake.log"  # of the last command
FUNCTIONS, FUNCTIONS_LOG = "fit.json", "fit.log"  # in the folder of a divided run
LOOK_S = 0.5  # from look to look at how far the jobs are


def find_profile(name):
    """The folder of a profile: one that comes with this, or the user's."""
    own = PROFILES / name
    folder = own if own.is_dir() else pathlib.Path(name)
    if not any(folder.glob("config*.yaml")):
        known = ", ".join(sorted(path.name for path in PROFILES.iterdir()))
        raise InputError(
            f'--profile: "{name}" is neither one of {known} nor a folder with '
            f"config.yaml; copy {PROFILES / 'slurm'} to make your own")
    return folder.resolve()


def find_deform(given, beside):
    """musclewarp-deform: as given, or beside the command, or of PATH."""
    if given:
        if not os.access(given, os.X_OK) or pathlib.Path(given).is_dir():
            raise InputError(f'--deform: "{given}" is not a program; name '
                             "musclewarp-deform, or leave it out")
        return str(pathlib.Path(given).absolute())
    return _find("musclewarp-deform", beside, beside.parent / "build/release/tools",
                 advice="install the package musclewarp, or name it with --deform")


def find_export(deform):
    """musclewarp-export: beside musclewarp-deform, or of PATH."""
    return _find("musclewarp-export", pathlib.Path(deform).parent,
                 advice="it fits the functions of divided runs; install the package "
                 "musclewarp")


def _find(name, *folders, advice):
    for folder in folders:
        if os.access(folder / name, os.X_OK):
            return str(folder / name)
    found = shutil.which(name)
    if not found:
        raise InputError(f"{name}: is neither in {folders[0]} nor in a folder of "
                         f"PATH; {advice}")
    return found


def find_snakemake():
    found = shutil.which("snakemake")
    if not found:
        raise InputError("snakemake: is not in a folder of PATH; install it: "
                         "apt install snakemake (Debian), or see "
                         "https://snakemake.github.io")
    return found


class Engine:
    """Calls of Snakemake in one folder, by one command at a time."""

    def __init__(self, out, settings, profile, cores, dry_run):
        self.out = out
        self.interrupted = False
        self.log = out / LOG
        self._begun = False
        self._dry_run = dry_run
        self._settings = settings
        self._words = [find_snakemake(), "--snakefile", str(WORKFLOW / "Snakefile"),
                       "--directory", str(out), "--configfile", str(out / SETTINGS),
                       "--keep-going", "--rerun-incomplete", "--nolock"]
        if dry_run:
            self._words += ["--dry-run"]
        self._where = ["--profile", str(profile)]
        if cores:
            self._where += ["--cores", str(cores), "--jobs", str(cores)]

    def run_jobs(self, jobs, divided):
        """Makes the records of jobs (table.Job) and the functions of divided runs,
        and tells on the screen how far the jobs are. Returns the exit code of
        Snakemake."""
        files = [f"{each.folder}/{RECORD}" for each in jobs]
        files += [f"{run.folder}/{FUNCTIONS}" for run in divided]
        return self._call([*files, *self._where], jobs)

    def gather(self):
        """Makes the table and the page of the group, here: that is quick."""
        return self._call(["group", "--cores", "1", "--force", "--allowed-rules",
                           "group"], [])

    def _call(self, words, jobs):
        """Runs Snakemake to its end. Ctrl-C reaches it without help; SIGTERM is
        handed on."""
        self.out.mkdir(parents=True, exist_ok=True)
        try:
            # Snakemake inherits the lock, but its jobs do not.
            with locked(self.out / ".cohort.lock", wait=False) as lock:
                write_atomically(self.out / SETTINGS, json.dumps(self._settings))
                with open(self.log, "ab" if self._begun else "wb") as log:
                    self._begun = True
                    progress = Progress(jobs, self.out, self.log)
                    code = self._wait(subprocess.Popen(
                        [*self._words, *words], pass_fds=[lock], stdout=log,
                        stderr=subprocess.STDOUT), progress)
                progress.end(code, self._dry_run)
                return code
        except BlockingIOError:
            raise InputError(
                f"{self.out}: another musclewarp-cohort, or the Snakemake that it "
                "has left, is at work here; wait for it, or end it") from None

    def _wait(self, child, progress):
        """The exit code of Snakemake; until it ends, the screen is kept up."""
        def interrupt(number, _frame):
            self.interrupted = True
            if number == signal.SIGTERM:
                child.terminate()

        before = {number: signal.signal(number, interrupt)
                  for number in (signal.SIGINT, signal.SIGTERM)}
        try:
            while True:
                try:
                    return child.wait(timeout=LOOK_S)
                except subprocess.TimeoutExpired:
                    progress.look()
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)
