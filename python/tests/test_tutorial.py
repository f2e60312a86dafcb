# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The tutorial runs: its Python and its commands, in the order of the page."""
import os
import re
import subprocess

from conftest import PROGRAMS, SOURCE

BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.M | re.S)


def without_figures(text):
    """Times and what is left of volume errors differ between machines."""
    return re.sub(r"(?<=error )[-.\de]+|[.\d]+(?= ms)", "#", text)


def test_tutorial(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PATH", f"{PROGRAMS}:{os.environ['PATH']}")
    text = (SOURCE / "docs/tutorial.md").read_text(encoding="utf-8")
    blocks = BLOCK.findall(text)
    assert [language for language, _ in blocks] == [
        "sh", "python", "sh", "python", "sh", "sh", "sh", "sh"]
    names, said = {}, ""
    for language, block in blocks:
        if language == "python":
            exec(compile(block, "docs/tutorial.md", "exec"), names)
        else:
            done = subprocess.run(["sh", "-ec", block], capture_output=True,
                                  text=True)
            assert done.returncode == 0, block + done.stdout + done.stderr
            said += done.stdout
    shown = re.findall(r"^    (.*\S)$", BLOCK.sub("", text), re.M)
    assert len(shown) >= 6
    for line in set(shown) - {"..."}:
        assert without_figures(line) in without_figures(said).split("\n"), line
    for page in ("my_hip/report.html", "my_model/report.html"):
        assert "<html" in (tmp_path / page).read_text(encoding="utf-8")
    assert (tmp_path / "my_model/moment_arms.sto").exists()
