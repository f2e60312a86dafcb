# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Plots of a page, as SVG."""
import html

from .outliers import medians, ranges

WIDTH, HEIGHT = 360, 130
LEFT, RIGHT, BOTTOM, TOP = 8, 352, 106, 14
SIDE = 56  # where curves begin, right of the values of their axis
MOST_BINS = 20
MOST_CURVES = 60
GOLDEN = 0.618  # its multiples keep apart


def figure(title, drawing):
    return (f"<figure><figcaption>{html.escape(title)}</figcaption>"
            f"{drawing}</figure>")


def _svg(parts, height=HEIGHT):
    return (f'<svg viewBox="0 0 {WIDTH} {height}" role="img">' + "".join(parts) +
            "</svg>")


def _axis(low, high, y, left=LEFT):
    """A line with the values at its ends and in the middle."""
    parts = [f'<line class="axis" x1="{left}" x2="{RIGHT}" y1="{y}" y2="{y}"/>']
    for value, anchor, x in ((low, "start", left),
                             ((low + high) / 2, "middle", (left + RIGHT) / 2),
                             (high, "end", RIGHT)):
        parts.append(f'<text x="{x}" y="{y + 14}" text-anchor="{anchor}">'
                     f"{value:.4g}</text>")
    return parts


def counts(values):
    """(smallest value, largest, how many are in each of equal bins)."""
    low, high = min(values), max(values)
    if low == high:
        return low, high, [len(values)]
    bins = [0] * min(MOST_BINS, 2 + len(values) // 2)
    for value in values:
        place = int((value - low) / (high - low) * len(bins))
        bins[min(place, len(bins) - 1)] += 1
    return low, high, bins


def histogram(values):
    """How many of the values lie where; those that are None are left out."""
    values = [value for value in values if value is not None]
    if not values:
        return _svg([f'<text x="{LEFT}" y="40">no figures</text>'], 60)
    low, high, bins = counts(values)
    width = (RIGHT - LEFT) / len(bins)
    parts = []
    for place, count in enumerate(bins):
        height = (BOTTOM - TOP) * count / max(bins)
        begin = low + place * (high - low) / len(bins)
        end = low + (place + 1) * (high - low) / len(bins)
        parts.append(
            f'<rect class="bar" x="{LEFT + place * width:.1f}" '
            f'y="{BOTTOM - height:.1f}" width="{max(width - 1, 1):.1f}" '
            f'height="{height:.1f}"><title>{begin:.4g} to {end:.4g}: {count}'
            "</title></rect>")
    parts.append(f'<text x="{RIGHT}" y="10" text-anchor="end">'
                 f"{len(values)} in all, at most {max(bins)} a bar</text>")
    return _svg(parts + _axis(low, high, BOTTOM))


def _span(values):
    """(smallest, largest) of an axis; values that are all the same get room."""
    low, high = min(values), max(values)
    room = (abs(low) or 1) * 0.01 if low == high else 0
    return low - room, high + room


def _scale(low, high, begin, end):
    """Takes values of an axis to the picture."""
    return lambda value: begin + (value - low) / (high - low) * (end - begin)


def dots(values, outliers):
    """A dot for each of {name: value}, over the values; heights mean nothing."""
    low, high = _span(values.values())
    x = _scale(low, high, LEFT + 4, RIGHT - 4)
    parts = []
    for place, (name, value) in enumerate(values.items()):
        y = TOP + 6 + (BOTTOM - TOP - 12) * (place * GOLDEN % 1)  # apart from others
        kind = "dot out" if name in outliers else "dot"
        parts.append(f'<circle class="{kind}" cx="{x(value):.1f}" cy="{y:.1f}" '
                     f'r="3.5"><title>{html.escape(name)}: {value:.4g}'
                     "</title></circle>")
    return _svg(parts + _axis(low, high, BOTTOM))


def _polyline(points, x, y, kind, name):
    """A curve; a dot, if it is of one point."""
    title = f"<title>{html.escape(name)}</title>"
    if len(points) == 1:
        (place, value), = points
        return (f'<circle class="dot {kind}" cx="{x(place):.1f}" '
                f'cy="{y(value):.1f}" r="3">{title}</circle>')
    drawn = " ".join(f"{x(place):.1f},{y(value):.1f}" for place, value in points)
    return f'<polyline class="{kind}" points="{drawn}">{title}</polyline>'


def _band(series, x, y, interpolate):
    """The range of curves, as an area."""
    span = ranges(series, interpolate)
    outline = ([(place, most) for place, _, most in span] +
               [(place, least) for place, least, _ in reversed(span)])
    drawn = " ".join(f"{x(place):.1f},{y(value):.1f}" for place, value in outline)
    return (f'<polygon class="band" points="{drawn}"><title>range of {len(series)} '
            "runs</title></polygon>")


def _height_axis(low, high, y):
    """The values at the ends and in the middle, left of the curves."""
    return [f'<text x="{SIDE - 4}" y="{y(value) + 4:.1f}" text-anchor="end">'
            f"{value:.4g}</text>" for value in (low, (low + high) / 2, high)]


def curves(series, outliers, label, interpolate):
    """Curves {name: sorted list of (place, value)} over an axis with a label, those
    of outliers on top, with the median of all where enough have a value. Of more
    than MOST_CURVES only the range is drawn, and outliers."""
    x_low, x_high = _span([place for curve in series.values() for place, _ in curve])
    low, high = _span([value for curve in series.values() for _, value in curve])
    x = _scale(x_low, x_high, SIDE, RIGHT - 4)
    y = _scale(low, high, BOTTOM - 4, TOP)
    others = {name: curve for name, curve in series.items() if name not in outliers}
    if len(others) > MOST_CURVES:
        parts = [_band(others, x, y, interpolate)]
    else:
        parts = [_polyline(curve, x, y, "", name) for name, curve in others.items()]
    middle = medians(series, interpolate)
    if middle:
        parts.append(_polyline(middle, x, y, "median", "median of the group"))
    parts += [_polyline(series[name], x, y, "out", name) for name in outliers]
    parts += _axis(x_low, x_high, BOTTOM, SIDE) + _height_axis(low, high, y)
    parts.append(f'<text x="{(SIDE + RIGHT) / 2}" y="{BOTTOM + 30}" '
                 f'text-anchor="middle">{html.escape(label)}</text>')
    return _svg(parts, BOTTOM + 36)
