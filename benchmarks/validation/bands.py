# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Bands of moment arms over an angle: published ones and those of fibres."""

import csv

import numpy as np

import svg

GRID = 401  # angles at which bands are compared, as score_moment_arms.py has it


class Published:
    """The bands of a table of lower and upper bounds over an angle, smoothed
    by polynomials of fourth order as score_moment_arms.py has them."""

    def __init__(self, path):
        self.bounds = {}
        with open(path, encoding="utf-8") as file:
            for row in csv.DictReader(file):
                points = self.bounds.setdefault((row["muscle"], row["bound"]), [])
                points.append((float(row["angle_deg"]), float(row["moment_arm_mm"])))

    def band(self, muscle, x):
        return [
            np.polyval(np.polyfit(*np.array(self.bounds[muscle, bound]).T, 4), x)
            for bound in ("lower", "upper")
        ]

    def known(self, muscle):
        """The angles for which both bounds were published."""
        x = [np.array(self.bounds[muscle, bound])[:, 0] for bound in ("lower", "upper")]
        return max(min(values) for values in x), min(max(values) for values in x)

    def drawn(self, muscle, low, high):
        """Bands for a plot: fainter beyond the published angles."""
        known = np.clip(self.known(muscle), low, high)
        pieces = [(known[0], known[1], "Blemker and Delp 2005", 0.38)]
        pieces += [(low, known[0], "", 0.15), (known[1], high, "", 0.15)]
        bands = []
        for start, end, label, opacity in pieces:
            if end - start > 0.05:
                x = np.linspace(start, end, 41)
                band = self.band(muscle, x)
                bands.append(svg.Band(label, x, *band, svg.BLUE, opacity=opacity))
        return bands

    def score(self, muscle, x, low, high):
        """The part of the published area that the band from `low` to `high`
        over the rising angles x covers, and the area of the intersection over
        that of the union; as score_moment_arms.py counts."""
        grid = np.linspace(x[0], x[-1], GRID)
        low, high = np.interp(grid, x, low), np.interp(grid, x, high)
        lower, upper = self.band(muscle, grid)
        both = np.clip(np.minimum(high, upper) - np.maximum(low, lower), 0, None)
        wanted = np.abs(upper - lower)
        union = wanted + (high - low) - both
        return both.sum() / wanted.sum(), both.sum() / union.sum()


def path_arms(run, lines, kind=""):
    """The moment arm in each frame of lines of which each begins where another
    ends, mm: as their muscle carries them, or of the straight "_path"."""
    return sum(
        run.column("moment_arms.sto", f"{line}{kind}.{run.moving}") for line in lines
    )


def fibre_band(run, muscle, coordinate):
    """The lowest and the highest moment arm of the fibres in each frame, mm."""
    arms = run.columns(
        "fibre_moment_arms.sto", f"{muscle}_fibre_", f".{coordinate}"
    )
    return arms.min(axis=1), arms.max(axis=1)
