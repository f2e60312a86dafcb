# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Plots of a page, as SVG."""
import html

WIDTH, HEIGHT = 360, 130
LEFT, RIGHT, BOTTOM, TOP = 8, 352, 106, 14
MOST_BINS = 20


def figure(title, drawing):
    return (f"<figure><figcaption>{html.escape(title)}</figcaption>"
            f"{drawing}</figure>")


def _svg(parts, height=HEIGHT):
    return (f'<svg viewBox="0 0 {WIDTH} {height}" role="img">' + "".join(parts) +
            "</svg>")


def _axis(low, high, y):
    """A line with the values at its ends and in the middle."""
    parts = [f'<line class="axis" x1="{LEFT}" x2="{RIGHT}" y1="{y}" y2="{y}"/>']
    for value, anchor, x in ((low, "start", LEFT),
                             ((low + high) / 2, "middle", (LEFT + RIGHT) / 2),
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


def strip(spans):
    """Ranges ((from, to), name) below each other."""
    low = min(least for (least, _), _ in spans)
    high = max(most for (_, most), _ in spans)
    scale = (RIGHT - LEFT - 2) / ((high - low) or 1)
    step = min(6.0, 60 / len(spans))
    parts = []
    for place, ((least, most), name) in enumerate(spans):
        y = TOP + place * step
        x1 = LEFT + (least - low) * scale
        x2 = LEFT + (most - low) * scale + 2
        parts.append(f'<line class="range" x1="{x1:.1f}" x2="{x2:.1f}" '
                     f'y1="{y:.1f}" y2="{y:.1f}"><title>{html.escape(name)}: '
                     f"{least:.4g} to {most:.4g}</title></line>")
    bottom = round(TOP + len(spans) * step + 4)
    return _svg(parts + _axis(low, high, bottom), bottom + 22)
