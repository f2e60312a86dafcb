# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Reads IN/subjects.tsv: a row, and a job, for each subject and motion.

Tab-separated, with a header, UTF-8; an empty field is "n/a", as in BIDS. Columns
that are not named here, such as age, are left alone. A row with a number of parts
is a design of postures, which is divided into as many jobs.
"""
import dataclasses
import difflib
import json
import pathlib
import re
from typing import Optional

from . import flags
from .input_error import InputError

TABLE = "subjects.tsv"
REQUIRED = ("participant_id", "scene")
COLUMNS = REQUIRED + ("model", "motion", "side", "flags")
PARTS = "parts"  # a column that may be missing
MOST_PARTS = 9999
EMPTY = "n/a"
# The folder of a row whose motion or poses are those of the scene.
SCENE_MOTION = "scene"
SIDES = ("left", "right")
FOLDER_FLAGS = ("data_root", "cache")
MOST_LINES = 20  # of a message
LONGEST_NAME = 100  # of a folder; file systems allow 255 bytes with what is added


@dataclasses.dataclass(frozen=True)
class Job:
    """A subject and a motion, or a part of its frames; paths are absolute."""

    participant: str
    motion: str  # the name of the folder: of the motion file, without extension
    scene: str
    model: Optional[str] = None
    motion_file: Optional[str] = None
    side: Optional[str] = None
    flags: tuple = ()
    line: int = 0  # of the table
    parts: int = 0  # 0: the run is not divided
    part: int = 0  # 1 to parts; 0: the whole run

    @property
    def folder(self):
        part = f"/part_{self.part:04}" if self.part else ""
        return f"{self.participant}/{self.motion}{part}"

    @property
    def title(self):
        """For messages."""
        part = f" part {self.part} of {self.parts}" if self.part else ""
        return f"{self.participant} {self.motion}{part}"

    def divided(self):
        """The jobs to run: one, or one for each part."""
        if not self.parts:
            return [self]
        return [dataclasses.replace(self, part=part + 1)
                for part in range(self.parts)]

    def data_root(self):
        """What paths in the scene are relative to."""
        given = flags.values(self.flags).get("data_root")
        return given or str(pathlib.Path(self.scene).parent)


def _problem(path, line, column, value, allowed, advice):
    return f'{path}, line {line}, {column}: "{value}" {allowed}; {advice}'


def _job(row, line, path, known_flags):
    """The job of a row, or an InputError with every problem of the row."""
    problems = []

    def where(column):
        return lambda *rest: _problem(path, line, column, *rest)

    def file(column):
        value = row[column]
        if value == EMPTY:
            return None
        found = path.parent / value
        if not found.is_file():
            problems.append(where(column)(
                value, f"is not a file of {path.parent}",
                "check the name; paths are relative to the folder of the table"))
        return str(found.absolute())

    for column in REQUIRED:
        if row[column] == EMPTY:
            problems.append(where(column)(EMPTY, "may not be here",
                                          "fill it in or remove the line"))
    for column, name in (("participant_id", row["participant_id"]),
                         ("motion", pathlib.PurePath(row["motion"]).stem)):
        if row[column] != EMPTY and not re.fullmatch(r"\w[\w.-]*", name, re.A):
            problems.append(where(column)(
                name, "cannot name a folder: only letters, digits, _, - and . "
                "are allowed, and the first is none of - and .", "rename it"))
        if len(name) > LONGEST_NAME:
            problems.append(where(column)(
                name[:20] + "...", f"has {len(name)} characters",
                f"allowed are {LONGEST_NAME}"))
    if row["side"] not in SIDES + (EMPTY,):
        problems.append(where("side")(row["side"], "is not a side",
                                      f"write {', '.join(SIDES)} or {EMPTY}"))
    parts = row.get(PARTS, EMPTY)
    if parts != EMPTY and not (re.fullmatch(r"[0-9]+", parts, re.A)
                               and 1 <= int(parts) <= MOST_PARTS):
        problems.append(where(PARTS)(
            parts, "is not a number of parts",
            f"write a whole number from 1 to {MOST_PARTS}, or {EMPTY}"))
    words = ()
    try:
        if row["flags"] != EMPTY:
            words = flags.split(row["flags"], where("flags"),
                                row["participant_id"], known_flags)
    except InputError as error:
        problems.append(str(error))
    if parts != EMPTY and "frames" in flags.values(words):
        problems.append(where("flags")(
            row["flags"], f'has frames, as the column "{PARTS}" has',
            f"remove --frames, or write {EMPTY} for the parts"))
    motion = (SCENE_MOTION if row["motion"] == EMPTY
              else pathlib.PurePath(row["motion"]).stem)
    job = Job(row["participant_id"], motion, file("scene") or "", file("model"),
              file("motion"), None if row["side"] == EMPTY else row["side"],
              _with_absolute_folders(words, path.parent), line)
    if problems:
        raise InputError(*problems)
    return job if parts == EMPTY else dataclasses.replace(job, parts=int(parts))


def _with_absolute_folders(words, folder):
    """Folders are relative to that of the table, as other paths; of a flag that
    is given twice musclewarp-deform takes the last."""
    values = flags.values(words)
    return words + tuple(f"--{name}={(folder / values[name]).absolute()}"
                         for name in FOLDER_FLAGS
                         if values.get(name) not in (None, "", "none"))


def _rows(path):
    """Yields (line, row by columns) of the table."""
    if not path.is_file():
        raise InputError(f"{path}: does not exist; IN is a folder with the table "
                         f"{TABLE} of the columns {', '.join(COLUMNS)}")
    try:
        lines = path.read_text(encoding="utf-8-sig").splitlines()
    except UnicodeDecodeError as error:
        raise InputError(f"{path}, byte {error.start}: not UTF-8; save the table "
                         "as UTF-8") from None
    header = [name.strip() for name in lines[0].split("\t")] if lines else []
    missing = [name for name in COLUMNS if name not in header]
    if missing:
        raise InputError(
            f"{path}, line 1: has no column {', '.join(missing)}; the columns "
            f"{', '.join(COLUMNS)} are needed, separated by tabs; fill one that "
            f"you do not need with {EMPTY}")
    for line, text in enumerate(lines[1:], 2):
        if not text.strip():
            continue
        fields = [field.strip() or EMPTY for field in text.split("\t")]
        if len(fields) != len(header):
            raise InputError(
                f"{path}, line {line}: has {len(fields)} fields, and the header "
                f"{len(header)}; separate fields by one tab each, and write "
                f"{EMPTY} where there is nothing")
        yield line, dict(zip(header, fields))


def read_jobs(folder, known_flags=None):
    """The jobs of the table of a folder, in its order. InputError names every
    row that is bad. `known_flags` are those of musclewarp-deform, as
    flags.of_program returns them; without it, flags are not looked up."""
    path = pathlib.Path(folder) / TABLE
    jobs, problems = {}, []
    for line, row in _rows(path):
        try:
            job = _job(row, line, path, known_flags)
        except InputError as error:
            problems += str(error).split("\n")
            continue
        before = jobs.setdefault(job.folder, job)
        if before is not job:
            problems.append(_problem(
                path, line, "participant_id", job.participant,
                f'has the motion "{job.motion}" in line {before.line}, too',
                "remove one of the lines, or rename the motion"))
    if len(problems) > MOST_LINES:
        more = len(problems) - MOST_LINES
        problems = problems[:MOST_LINES] + [f"{path}: {more} more of the kind"]
    if problems:
        raise InputError(*problems)
    if not jobs:
        raise InputError(f"{path}: has no subjects; add a line for each")
    return list(jobs.values())


def choose(jobs, labels):
    """The jobs of some participants; labels may leave out "sub-"."""
    known = list(dict.fromkeys(job.participant for job in jobs))
    chosen, problems = set(), []
    for label in labels:
        names = {label, f"sub-{label}"}.intersection(known)
        chosen |= names
        if not names:
            near = difflib.get_close_matches(label, known, 3) or known[:3]
            problems.append(f'--participant-label: "{label}" is not in {TABLE}; '
                            f"there are {len(known)}, such as {', '.join(near)}")
    if problems:
        raise InputError(*problems)
    return [job for job in jobs if job.participant in chosen]


def _model_meshes(model, folders):
    """The mesh files that an OpenSim model names, where they may be."""
    try:
        text = pathlib.Path(model).read_text(encoding="utf-8", errors="replace")
    except OSError:
        return []
    names = re.findall(r"<(?:mesh_file|geometry_file)>\s*([^<]*?)\s*<", text)
    home = pathlib.Path(model).parent
    places = [*folders, home, home / "Geometry"]
    return [str(pathlib.Path(place) / name.replace("\\", "/"))
            for name in names for place in places]


def _scene_files(job, scene, root):
    """The files that a scene names; those of a model are looked for."""
    items = [item for key in ("muscles", "bones")
             if isinstance(scene.get(key), list) for item in scene[key]]
    # One object of a file is named as FILE#NAME.
    named = [re.sub(r"#[^#]*$", "", item["mesh"]) for item in items
             if item.get("mesh")]
    named += [item["mesh"] for item in items if item.get("mesh")]
    named += [scene[key]["path"] for key in ("poses_file", "attachments_file")
              if key in scene]
    motion = scene.get("motion")  # a file, or in the scene itself
    if isinstance(motion, str) and not job.motion_file:
        named.append(motion)
    files = [str(root / name) for name in named]
    model = job.model or (scene.get("model") and str(root / scene["model"]))
    if model:
        folders = scene.get("geometry", [])
        folders = [folders] if isinstance(folders, str) else folders
        files += [model,
                  *_model_meshes(model, [root / folder for folder in folders])]
    return files


def input_files(job):
    """The files that a job reads and that are there: what musclewarp-deform
    refuses is found by itself."""
    files = [job.scene, job.model, job.motion_file]
    root = pathlib.Path(job.data_root())
    try:
        scene = json.loads(pathlib.Path(job.scene).read_text(encoding="utf-8"))
        files += _scene_files(job, scene, root)
    except (OSError, ValueError, TypeError, KeyError, AttributeError):
        pass
    return [file for file in dict.fromkeys(files)
            if file and pathlib.Path(file).is_file()]
