# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Reads the table of facts on shape, and writes lines of a table beside them."""

import csv
import re

from table import plain

# They end the mark of a fact that says nothing of how muscles are deformed:
# it is of the meshes as they came, or what the method imposes.
MESH, IMPOSED = " (mesh)", " (imposed)"

HEAD = ["muscle", "what", "measured", "ours", "held?", "source"]


class Facts:
    """Rows of the table of facts; what is asked for has to be there."""

    def __init__(self, data):
        self.path = data / "literature/shape_facts.csv"
        with open(self.path, newline="", encoding="utf-8") as file:
            self.rows = list(csv.DictReader(file))

    def find(self, muscle, quantity, condition, unit=None):
        asked = {"muscle": muscle, "quantity": quantity, "condition": condition}
        if unit is not None:
            asked["unit"] = unit
        found = [r for r in self.rows if all(r[k] == asked[k] for k in asked)]
        if not found:
            raise ValueError(f"{self.path}: no row with {asked}")
        return found


def source(row):
    """Its source in short, with the doi if there is one."""
    short = re.sub(r" \([^()]*\)$", "", row["source"])
    doi = row["doi_or_pmcid"].split(" ")[0]
    return f"{short}, {doi}" if doi.startswith("10.") else short


def line_of(row, measured, ours, held, what="", note=""):
    """A row of the section; a fact without a value is a trend."""
    note = note or ("" if row["value"] else " (trend)")
    return [
        plain(row["muscle"]),
        what or row["quantity"],
        measured or row["unit"],
        ours,
        ("🟢" if held else "🔴") + note,
        source(row),
    ]


def values(rows):
    return sorted(float(row["value"]) for row in rows)
