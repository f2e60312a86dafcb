# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Compares what Python and the programs write of one scene."""
import json
import pathlib
import subprocess

import musclewarp as mw
from conftest import PROGRAMS

# What depends on the machine, the moment, or how the run was asked for.
_OF_THE_RUN = {"command", "options", "inputs_hash", "machine"}


def files_of(folder):
    """The bytes of all files below a folder, by their paths in it."""
    folder = pathlib.Path(folder)
    return {str(path.relative_to(folder)): path.read_bytes()
            for path in folder.rglob("*") if path.is_file()}


def without_times(report):
    """A report without what differs from run to run."""
    if isinstance(report, dict):
        return {key: without_times(value) for key, value in report.items()
                if not key.endswith("_ms") and "_ms_" not in key
                and key not in _OF_THE_RUN}
    if isinstance(report, list):
        return [without_times(entry) for entry in report]
    return report


def expect_same_files(scene_path, tmp_path, data_root="", frames=None,
                      **choices):
    """Runs a scene both ways and compares all files, byte for byte."""
    scene = mw.read_scene(scene_path, data_root=data_root)
    poses = scene.poses if frames is None else scene.poses[:frames]
    run = mw.run(scene, poses, **choices)
    run.write(tmp_path / "python")
    command = [PROGRAMS / "musclewarp-deform", f"--scene={scene_path}",
               f"--out={tmp_path / 'program'}",
               *(f"--{name}={value}" for name, value in choices.items())]
    if data_root:
        command.append(f"--data_root={data_root}")
    if frames is not None:
        command.append(f"--frames=0:{frames - 1}")
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    here = files_of(tmp_path / "python")
    there = files_of(tmp_path / "program")
    reports = [json.loads(files.pop("report.json")) for files in (here, there)]
    assert sorted(here) == sorted(there)
    assert [name for name in here if here[name] != there[name]] == []
    assert without_times(reports[0]) == without_times(reports[1])
    return run
