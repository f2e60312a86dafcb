# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs what stands in the boxes of docs/tutorial.md."""
import ast
import os
import re
import subprocess
import sys

from conftest import PROGRAMS, SOURCE

BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.M | re.S)
SHOWN = re.compile(r"^    (.*\S)$", re.M)


def parts_of_tutorial():
    """The page up to the walk through an official model, and that walk."""
    text = (SOURCE / "docs/tutorial.md").read_text(encoding="utf-8")
    parts = text.split("## With a model that comes with OpenSim")
    assert len(parts) == 2
    return parts


def packages_of(source):
    """The packages that a text of Python imports, but for Python's own."""
    names = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names |= {each.name.partition(".")[0] for each in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add(node.module.partition(".")[0])
    return names - sys.stdlib_module_names


def without_figures(text):
    """Times, what is left of volume errors and the signs of zeros differ
    between machines."""
    text = re.sub(r"(?<=error )[-.\de]+|[.\d]+(?= ms| microseconds)", "#", text)
    return re.sub(r"-(?=0\.0\b)", "", text)


def expect_runs(text, languages, folder, monkeypatch):
    """Runs the boxes in the folder; what is shown has to be printed."""
    monkeypatch.chdir(folder)
    monkeypatch.setenv("PATH", f"{PROGRAMS}:{os.environ['PATH']}")
    blocks = BLOCK.findall(text)
    assert [language for language, _ in blocks] == languages
    names, said = {}, ""
    for language, block in blocks:
        if language == "python":
            exec(compile(block, "docs/tutorial.md", "exec"), names)
        else:
            done = subprocess.run(["sh", "-ec", block], capture_output=True,
                                  text=True)
            assert done.returncode == 0, block + done.stdout + done.stderr
            said += done.stdout
    shown = set(SHOWN.findall(BLOCK.sub("", text))) - {"..."}
    assert len(shown) >= 5
    printed = [line.strip() for line in without_figures(said).split("\n")]
    for line in shown:
        assert without_figures(line).strip() in printed, line
    return said
