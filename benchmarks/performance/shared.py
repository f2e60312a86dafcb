# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Makes the plots, tables and readers of benchmarks/validation importable."""

import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "validation"))
