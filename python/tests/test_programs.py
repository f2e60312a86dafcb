# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Python and the programs give the same bytes for the same scene."""
import subprocess

import musclewarp as mw
from conftest import DEMO, PROGRAMS
from same_files import expect_same_files, files_of


def test_the_embedded_scene(tmp_path):
    run = expect_same_files(DEMO, tmp_path)
    assert len(run.frames) == 15
    assert run.report()["summary"]["usable"]


def test_the_paper_contact_with_other_choices(tmp_path):
    expect_same_files(DEMO, tmp_path, frames=2, contact="paper",
                      coarse_vertices=80, fibres=3)


def deform(*flags):
    return subprocess.run([PROGRAMS / "musclewarp-deform", *flags],
                          capture_output=True, text=True)


def test_the_demo_is_the_embedded_scene(tmp_path):
    done = deform("--demo", f"--out={tmp_path / 'demo'}", "--frames=0")
    assert done.returncode == 0, done.stdout + done.stderr
    there = files_of(tmp_path / "demo")
    assert "report.html" in there
    assert there["scene/motion.json"] == DEMO.read_bytes()
    scene = mw.demo_scene()
    mw.run(scene, scene.poses[:1]).write(tmp_path / "python")
    here = files_of(tmp_path / "python")
    meshes = [name for name in here if name.endswith(".ply")]
    assert len(meshes) == 10
    assert [name for name in meshes if here[name] != there[name]] == []


def test_a_demo_with_bad_flags_writes_nothing(tmp_path):
    out = tmp_path / "demo"
    for flag, words in ((f"--scene={DEMO}", "--demo: is given with --scene"),
                        ("--data_root=.", "is given with --data_root"),
                        ("--gap=-1", "--gap: is -1")):
        done = deform("--demo", f"--out={out}", flag)
        assert done.returncode == 2
        assert words in done.stderr
        assert not out.exists()
    done = deform("--demo")
    assert done.returncode == 2 and "--out: is missing" in done.stderr
