#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs the Python tests of a folder.

usage: tests_of.py FOLDER

Exits with 77 if numpy is not there.
"""
import sys
import unittest

try:
    import numpy  # noqa: F401
except ImportError as error:
    print(f"skipped: {error}; apt-get install python3-numpy")
    sys.exit(77)

unittest.main(module=None, argv=["", "discover", "-s", sys.argv[1], "-p", "*_test.py"])
