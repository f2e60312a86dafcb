# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The exception for bad input."""


class InputError(ValueError):
    """Bad input: each line says where, what was seen, what is allowed, and what
    to do."""

    def __init__(self, *lines):
        super().__init__("\n".join(lines))
