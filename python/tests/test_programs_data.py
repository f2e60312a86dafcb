# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The same bytes for LHDL. Needs MUSCLEWARP_DATA_ROOT."""
import os

import pytest

from conftest import SOURCE
from same_files import expect_same_files

DATA = os.environ.get("MUSCLEWARP_DATA_ROOT", "")


@pytest.mark.skipif(not DATA, reason="MUSCLEWARP_DATA_ROOT is not set")
@pytest.mark.parametrize("scene, frames", [("lhdl_hip", 1),
                                           ("lhdl_hip_motion", 1)])
def test_lhdl(scene, frames, tmp_path):
    expect_same_files(SOURCE / f"data/scenes/{scene}.json", tmp_path,
                      data_root=DATA, frames=frames)
