# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Plots of curves and bands as small SVG files. The greys and colours can be
read on white and on black."""

import dataclasses
import math
from xml.sax.saxutils import escape

import numpy as np

WIDTH, HEIGHT = 640, 380
LEFT, RIGHT, TOP, BOTTOM = 62, 16, 60, 50
GREY = "#7d7d7d"
BLUE, ORANGE, GREEN = "#3f8fd8", "#e07b18", "#2f9e5a"


@dataclasses.dataclass
class Band:
    """The area between two curves: filled, or with an outline only."""

    label: str
    x: np.ndarray
    low: np.ndarray
    high: np.ndarray
    color: str
    filled: bool = True
    opacity: float = 0.38


@dataclasses.dataclass
class Curve:
    label: str
    x: np.ndarray
    y: np.ndarray
    color: str
    dashes: str = ""
    width: float = 2


@dataclasses.dataclass
class Dots:
    label: str
    x: np.ndarray
    y: np.ndarray
    color: str


def ticks(low, high, about=7):
    """Returns round numbers from low to high."""
    step = 10 ** math.floor(math.log10((high - low) / about))
    for factor in (1, 2, 5, 10):
        if (high - low) / (step * factor) <= about:
            break
    step *= factor
    first, last = math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9)
    return [k * step for k in range(first, last + 1)]


def color_style(item):
    if isinstance(item, Curve):
        dashes = f' stroke-dasharray="{item.dashes}"' if item.dashes else ""
        return f'fill="none" stroke="{item.color}" stroke-width="{item.width}"{dashes}'
    if isinstance(item, Dots) or item.filled:
        opacity = 1 if isinstance(item, Dots) else item.opacity
        return f'fill="{item.color}" fill-opacity="{opacity}" stroke="none"'
    return f'fill="none" stroke="{item.color}" stroke-width="2"'


class Plot:
    """Bands and curves over an axis, drawn in their order."""

    def __init__(self, title, x_label, y_label, items):
        self.title, self.x_label, self.y_label = title, x_label, y_label
        self.items = items
        x = np.concatenate([item.x for item in items])
        y = [[i.low, i.high] if isinstance(i, Band) else [i.y] for i in items]
        y = np.concatenate([values for pair in y for values in pair])
        margin = 0.05 * (y.max() - y.min() or 1)
        self.x_range = x.min(), x.max()
        self.y_range = y.min() - margin, y.max() + margin

    def _x(self, value):
        low, high = self.x_range
        return LEFT + (value - low) / (high - low) * (WIDTH - LEFT - RIGHT)

    def _y(self, value):
        low, high = self.y_range
        return HEIGHT - BOTTOM - (value - low) / (high - low) * (HEIGHT - TOP - BOTTOM)

    def _points(self, x, y):
        return " ".join(f"{self._x(a):.1f},{self._y(b):.1f}" for a, b in zip(x, y))

    def _item(self, item):
        if isinstance(item, Curve):
            points = self._points(item.x, item.y)
            return f'<polyline {color_style(item)} points="{points}"/>'
        if isinstance(item, Dots):
            return "".join(
                f'<circle {color_style(item)} cx="{self._x(x):.1f}" '
                f'cy="{self._y(y):.1f}" r="3.5"/>'
                for x, y in zip(item.x, item.y)
            )
        x = np.concatenate([item.x, item.x[::-1]])
        points = self._points(x, np.concatenate([item.low, item.high[::-1]]))
        return f'<polygon {color_style(item)} points="{points}"/>'

    def _ticks(self, low, high):
        """Returns where marks of an axis are, and the numbers beside them."""
        return [(value, value) for value in ticks(low, high)]

    def _axes(self):
        lines, right, bottom = [], WIDTH - RIGHT, HEIGHT - BOTTOM
        for value, number in self._ticks(*self.x_range):
            x = self._x(value)
            lines.append(f'<path d="M{x:.1f} {bottom}v5"/>')
            lines.append(text(x, bottom + 19, f"{number:g}", "middle"))
        for value, number in self._ticks(*self.y_range):
            y = self._y(value)
            width = 1.2 if number == 0 else 0.4
            lines.append(
                f'<path d="M{LEFT} {y:.1f}H{right}" stroke-width="{width}"/>'
            )
            lines.append(text(LEFT - 7, y + 4, f"{number:g}", "end"))
        lines.append(f'<path d="M{LEFT} {TOP}V{bottom}H{right}"/>')
        middle = (LEFT + right) / 2
        lines.append(text(middle, HEIGHT - 10, self.x_label, "middle"))
        y = (TOP + bottom) / 2
        lines.append(
            text(16, y, self.y_label, "middle", f' transform="rotate(-90 16 {y:g})"')
        )
        return lines

    def _legend(self):
        lines, x = [], LEFT
        for item in self.items:
            if not item.label:
                continue
            style = color_style(item)
            if isinstance(item, Curve):
                lines.append(f'<path {style} d="M{x} 42h22"/>')
            else:
                lines.append(f'<rect {style} x="{x}" y="36" width="22" height="11"/>')
            lines.append(text(x + 27, 46, item.label))
            x += 41 + round(6.7 * len(item.label) + 4 * item.label.count("m"))
        return lines

    def write(self, path):
        lines = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
            f'width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" '
            'font-size="12.5">',
            f"<title>{escape(self.title)}</title>",
            *(self._item(item) for item in self.items),
            f'<g fill="none" stroke="{GREY}">',
            *self._axes(),
            text(LEFT, 22, self.title, more=' font-size="15"'),
            *self._legend(),
            "</g>",
            "</svg>",
        ]
        path.write_text("\n".join(lines) + "\n")


def text(x, y, words, anchor="start", more=""):
    return (
        f'<text x="{x:.1f}" y="{y:g}" text-anchor="{anchor}" fill="{GREY}" '
        f'stroke="none"{more}>{escape(words)}</text>'
    )
