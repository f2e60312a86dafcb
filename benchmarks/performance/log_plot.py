# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Plots with logarithmic axes."""

import dataclasses
import math

import numpy as np
import shared  # noqa: F401, where svg is
from svg import Curve, Plot


@dataclasses.dataclass
class Points(Curve):
    """Circles in place of a line."""


def log_ticks(low, high):
    """Round numbers from low to high: more of a decade where there is one only."""
    factors = (1, 2, 5) if high > 10 * low else (1, 1.5, 2, 3, 4, 5, 6, 8)
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    marks = [factor * 10.0**decade for decade in decades for factor in factors]
    return [mark for mark in marks if low <= mark <= high]


class LogPlot(Plot):
    """Curves and points of positive numbers."""

    def __init__(self, title, x_label, y_label, items):
        logs = [
            dataclasses.replace(item, x=np.log10(item.x), y=np.log10(item.y))
            for item in items
        ]
        super().__init__(title, x_label, y_label, logs)
        low, high = self.x_range
        margin = 0.05 * (high - low or 1)
        self.x_range = low - margin, high + margin

    def _ticks(self, low, high):
        return [(math.log10(mark), mark) for mark in log_ticks(10**low, 10**high)]

    def _item(self, item):
        if not isinstance(item, Points):
            return super()._item(item)
        return "\n".join(
            f'<circle fill="{item.color}" cx="{self._x(x):.1f}" cy="{self._y(y):.1f}" r="4"/>'
            for x, y in zip(item.x, item.y)
        )
