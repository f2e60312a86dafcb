# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Python and the programs give the same bytes for the same scene."""
from conftest import DEMO
from same_files import expect_same_files


def test_the_embedded_scene(tmp_path):
    run = expect_same_files(DEMO, tmp_path)
    assert len(run.frames) == 15
    assert run.report()["summary"]["usable"]


def test_the_paper_contact_with_other_choices(tmp_path):
    expect_same_files(DEMO, tmp_path, frames=2, contact="paper",
                      coarse_vertices=80, fibres=3)
