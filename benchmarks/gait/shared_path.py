# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Makes the plots, tables and chapters of the other benchmarks importable."""

import pathlib
import sys

BENCHMARKS = pathlib.Path(__file__).resolve().parents[1]
sys.path += [str(BENCHMARKS / name) for name in ("performance", "validation")]
