# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The tutorial runs: its Python and its commands, in the order of the page."""
from tutorial import expect_runs, parts_of_tutorial


def test_tutorial(tmp_path, monkeypatch):
    expect_runs(parts_of_tutorial()[0],
                ["sh", "sh", "python", "sh", "sh"] +
                ["sh", "python", "sh", "python", "sh", "sh", "sh", "sh"],
                tmp_path, monkeypatch)
    for page in ("hip/joints.html", "moved/report.html",
                 "my_hip/report.html", "my_model/report.html"):
        assert "<html" in (tmp_path / page).read_text(encoding="utf-8")
    assert (tmp_path / "my_model/moment_arms.sto").exists()
