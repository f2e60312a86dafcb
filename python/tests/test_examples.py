# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The examples run."""
import json
import subprocess
import sys

import pytest

import musclewarp as mw
from conftest import DEMO, SOURCE
from tutorial import packages_of

EXAMPLES = SOURCE / "examples"
PHANTOM = SOURCE / "data/phantom"
MESHES = [str(PHANTOM / f"{name}_r.ply")
          for name in ("gluteus_medius", "gluteus_minimus")]


def run(name, *arguments, folder=None):
    done = subprocess.run([sys.executable, EXAMPLES / name, *arguments],
                          capture_output=True, text=True, cwd=folder)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.mark.parametrize("name", sorted(
    path.name for path in EXAMPLES.glob("*.py")))
def test_runs_without_arguments(name, tmp_path):
    """Anywhere, and without leaving anything behind."""
    assert run(name, folder=tmp_path)
    assert not list(tmp_path.iterdir())


def test_deform_scene(tmp_path):
    said = run("deform_scene.py", f"--scene={DEMO}", f"--out={tmp_path / 'out'}",
               "--frames=2")
    assert said == "t=0: usable\nt=0.05: usable\n"
    assert (tmp_path / "out/frame_0001/psoas_major_r.ply").exists()


def test_own_arrays():
    assert "the iliacus moved by" in run("own_arrays.py")


def test_separate_meshes(tmp_path):
    said = run("separate_meshes.py", "--out", tmp_path, "--muscles", *MESHES,
               "--bones", PHANTOM / "femur_r.ply")
    assert said.startswith("usable\n")
    assert len(list(tmp_path.glob("*.ply"))) == 3


def test_check_meshes():
    said = run("check_meshes.py", *MESHES)
    assert "gluteus_medius_r and gluteus_minimus_r" in said
    assert "pelvis" not in said  # which the hip of the package has


def test_moment_arms():
    said = run("moment_arms.py", f"--scene={DEMO}", "--frames=3")
    assert "glut_med1_r_path.hip_flexion_r" in said
    assert "as carried" in said


def test_path_functions(tmp_path):
    file = tmp_path / "scene/postures.json"
    mw.demo_scene(tmp_path)
    scene = json.loads((tmp_path / "scene/motion.json").read_text())
    scene["motion"] = {"design": "grid", "postures": 4, "coordinates": {
        "hip_flexion_r": [0, 20], "hip_rotation_r": [-5, 5]}}
    file.write_text(json.dumps(scene))
    done = mw.run(mw.read_scene(file), coarse_vertices=60, contact="none")
    done.write(tmp_path / "run", bones="once")
    said = run("path_functions.py", f"--run={tmp_path / 'run'}",
               "--path=glut_med1_r", "--arm=hip_rotation_r")
    assert "7 functions of 4 frames" in said
    assert ("moment arm of glut_med1_r about hip_rotation_r, mm; down: "
            "hip_rotation_r, degrees; across: hip_flexion_r, degrees") in said
    assert "     0.0     5.0    10.0    15.0    20.0\n" in said


# What a script takes if it is there, and runs without.
OPTIONAL = {"path_functions.py": {"matplotlib"}}


def test_scripts_and_notebooks_need_numpy_alone():
    sources = {path.name: path.read_text() for path in EXAMPLES.glob("*.py")}
    for path in EXAMPLES.glob("*.ipynb"):
        sources[path.name] = "\n".join(
            "".join(cell["source"]) for cell in json.loads(path.read_text())["cells"]
            if cell["cell_type"] == "code")
    for name, source in sources.items():
        needed = packages_of(source) - OPTIONAL.get(name, set())
        assert needed <= {"musclewarp", "numpy"}, name


@pytest.mark.parametrize("notebook", sorted(EXAMPLES.glob("*.ipynb")),
                         ids=lambda path: path.name)
def test_notebooks(notebook, monkeypatch):
    """Runs the cells as Jupyter would, and shows what is last in them."""
    import ast
    monkeypatch.chdir(SOURCE)
    names, shown = {}, []
    for cell in json.loads(notebook.read_text())["cells"]:
        if cell["cell_type"] != "code":
            continue
        assert cell["outputs"] == [], "clear the outputs before committing"
        tree = ast.parse("".join(cell["source"]))
        last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, notebook.name, "exec"), names)
        if last:
            value = eval(compile(ast.Expression(last.value), notebook.name,
                                 "eval"), names)
            shown.append(getattr(value, "_repr_html_", value.__repr__)()
                         if value is not None else "")
    assert shown[-1].startswith("<iframe")
