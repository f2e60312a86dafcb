# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The walk through an official model of OpenSim in docs/tutorial.md. Needs
MUSCLEWARP_DATA_ROOT, which has its files in other folders."""
import os
import pathlib

import pytest

from tutorial import SHOWN, expect_runs, parts_of_tutorial

DATA = os.environ.get("MUSCLEWARP_DATA_ROOT", "")
MODEL = "Models/Gait2392_Simbody/gait2392_thelen2003muscle.osim"
MOTION = "Pipelines/Gait2392_Simbody/OutputReference/subject01_walk1_ik.mot"


@pytest.mark.skipif(not DATA, reason="MUSCLEWARP_DATA_ROOT is not set")
def test_walk_with_gait2392(tmp_path, monkeypatch):
    opensim = pathlib.Path(DATA) / "opensim"
    files = {MODEL: opensim / "gait2392_thelen2003muscle.osim",
             MOTION: opensim / "examples/subject01_walk1_ik.mot"}
    for mesh in opensim.glob("*.vtp"):
        files[f"Geometry/{mesh.name}"] = mesh
    for name, file in files.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).symlink_to(file)
    walk = parts_of_tutorial()[1]
    # The first box that is shown is the list of the files.
    for line in SHOWN.findall(walk)[:3]:
        name = line.split()[0]
        assert (tmp_path / name).exists(), name
        walk = walk.replace(f"    {line}\n", "", 1)
    said = expect_runs(walk, ["sh", "python", "sh"], tmp_path,
                       monkeypatch)
    assert "missing face" in said
    assert "<html" in (tmp_path / "walk/report.html").read_text(
        encoding="utf-8")
