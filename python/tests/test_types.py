# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The package is typed, and the stubs say what is there."""
import os
import subprocess
import sys

from conftest import SOURCE

# Of pybind11 itself: its classes have a metaclass of their own, and those
# without a constructor take any arguments to refuse them.
_OF_PYBIND11 = ("metaclass differs", 'stub does not have *args argument')

USER = """
import numpy as np
import musclewarp as mw

def widest(scene: mw.Scene) -> float:
    deformer = mw.Deformer(scene, gap=0.2, progress=lambda s, d, t: None)
    frame = deformer.move_to(scene.poses[0])
    for muscle in frame.muscles:
        reveal_type(muscle.points)
    bad: str = frame.usable
    mw.Deformer(scene, gpa=0.2)
    return float(np.max(frame.muscles[0].gaps))
"""


def mypy(module, tmp_path, *arguments):
    environment = dict(os.environ, MYPYPATH=os.environ["PYTHONPATH"],
                       MYPY_CACHE_DIR=str(tmp_path / "cache"))
    return subprocess.run([sys.executable, "-m", module, *arguments],
                          capture_output=True, text=True, cwd=tmp_path,
                          env=environment)


def test_the_package_is_typed_strictly(tmp_path):
    said = mypy("mypy", tmp_path, "--config-file",
                str(SOURCE / "pyproject.toml"),
                str(SOURCE / "python/musclewarp"))
    assert said.returncode == 0, said.stdout + said.stderr


def test_the_stubs_say_what_the_module_has(tmp_path):
    said = mypy("mypy.stubtest", tmp_path, "musclewarp._core", "--concise")
    wrong = [line for line in said.stdout.splitlines()
             if line.startswith("musclewarp.")
             and not any(text in line for text in _OF_PYBIND11)]
    assert wrong == []
    assert "Mesh" in said.stdout, said.stdout + said.stderr  # it did look


def test_mistakes_of_users_are_found(tmp_path):
    (tmp_path / "user.py").write_text(USER)
    said = mypy("mypy", tmp_path, "--strict", "user.py").stdout
    assert 'note: Revealed type is "numpy.ndarray[Any, numpy.dtype[numpy.' \
        'floating[' in said
    assert 'user.py:10: error: Incompatible types in assignment' in said
    assert 'user.py:11: error: Unexpected keyword argument "gpa"' in said
    assert said.count("error:") == 2, said
