# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The exception for bad input."""


class InputError(ValueError):
    """Bad input: a file, a field of a scene, an argument, an option.

    Attributes:
        where: names the file, field or argument.
        problem: what was seen, and what is allowed.
        advice: what to do about it.
    """

    def __init__(self, where: str, problem: str, advice: str) -> None:
        super().__init__(where, problem, advice)
        self.where = where
        self.problem = problem
        self.advice = advice

    def __str__(self) -> str:
        return f"{self.where}: {self.problem}; {self.advice}"
