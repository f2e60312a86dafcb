# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The tutorial runs: its Python and its commands, in the order of the page."""
from tutorial import BLOCK, expect_runs, packages_of, parts_of_tutorial


def test_tutorial(tmp_path, monkeypatch):
    expect_runs(parts_of_tutorial()[0],
                ["sh", "sh", "python", "sh", "sh"] +
                ["sh", "python", "sh", "python", "sh", "sh", "sh", "sh"] +
                ["sh", "python"],
                tmp_path, monkeypatch)
    for page in ("hip/joints.html", "moved/report.html",
                 "my_hip/report.html", "my_model/report.html"):
        assert "<html" in (tmp_path / page).read_text(encoding="utf-8")
    assert (tmp_path / "my_model/moment_arms.sto").exists()
    assert (tmp_path / "fit.json").exists()


def test_boxes_need_numpy_alone():
    """Images are written and read without a library for images."""
    boxes = [source for language, source in BLOCK.findall("".join(parts_of_tutorial()))
             if language == "python"]
    assert {"numpy"} < set().union(*map(packages_of, boxes))
    for source in boxes:
        assert packages_of(source) <= {"musclewarp", "numpy"}, source
