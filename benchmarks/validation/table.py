# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Tables in Markdown, of which rows say whether a target is met."""

import dataclasses
import textwrap
import typing

# Colours that GitHub shows in Markdown.
MARKS = {True: "🟢 met", False: "🔴 **not met**", None: "no target"}


@dataclasses.dataclass
class Row:
    """What is asked for, and what was measured."""

    requirement: str
    target: str
    measured: str
    met: typing.Optional[bool]  # None where there is no target


@dataclasses.dataclass
class Section:
    """A section of the page, and its rows of the summary."""

    title: str
    text: str
    rows: list


def mark(met):
    return MARKS[met]


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    return "\n".join(lines)


def table_of(rows):
    """The table of Rows."""
    return table(
        ["requirement", "target", "measured", "met?"],
        [[row.requirement, row.target, row.measured, mark(row.met)] for row in rows],
    )


def plain(name):
    """A name as words: gluteus_medius_r is gluteus medius."""
    return name.removesuffix("_r").replace("_", " ")


def commands(lines):
    """An indented block of code."""
    return "\n".join("    " + line for line in lines)


def prose(*sentences):
    """A paragraph, wrapped."""
    words = " ".join(" ".join(sentences).split())
    return textwrap.fill(
        words, 96, break_long_words=False, break_on_hyphens=False
    )


def paragraphs(*parts):
    return "\n\n".join(parts) + "\n"


def power(value):
    """A figure as 7.9e-9."""
    mantissa, exponent = f"{value:.1e}".split("e")
    return f"{mantissa.removesuffix('.0')}e{int(exponent)}"


def number(value, digits=2):
    """A figure for a table: small ones in powers of ten, zero as 0."""
    if value == 0:
        return "0"
    return power(value) if abs(value) < 10**-digits / 2 else f"{value:.{digits}f}"


def span(values, digits=1):
    return f"{min(values):.{digits}f} to {max(values):.{digits}f}"
