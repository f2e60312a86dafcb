# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Which subjects are far from the others: a rule that a few of them do not move,
since it rests on medians."""
import bisect
import dataclasses
import math
import statistics

LIMIT = 3.5  # scaled median absolute deviations
SCALE = 1.4826  # of them to a standard deviation, where values are normal
# What differs by less is none, however alike the others are: a share of the largest
# median of a curve.
LEAST_SHARE = 0.01
FEWEST = 5  # runs at a place; of fewer no outliers are sought
MOST_PLACES = 21  # at which curves are compared
SAME = 1e-6  # of the range of an axis: values that differ by less are one

RULE = (f"An outlier is more than {LIMIT} scaled median absolute deviations "
        f"({SCALE} times the median of the distances from the median) from the "
        "group's median at any value that is compared, and by more than "
        f"{LEAST_SHARE:.0%} of the largest median of that curve. Curves are "
        f"compared at up to {MOST_PLACES} values of the axis at which at least "
        f"{FEWEST} runs have a frame, or, if there are none, at evenly spaced ones; "
        "between two frames of a run they are straight. Of fewer than "
        f"{FEWEST} runs no outliers are sought. Values are not scaled by the size of "
        "a subject. Chance alone puts a subject on the list in about one of five "
        "quantities of five subjects, and of twenty or more in one of ten.")


@dataclasses.dataclass(frozen=True)
class Outlier:
    """Where a curve is farthest from the others, in what the rule allows."""

    name: str  # of the curve
    place: float  # on the axis
    value: float
    median: float  # of the group, there
    excess: float  # the distance over what the rule allows: more than 1


def value_at(curve, place, tolerance, interpolate=True):
    """The value of a curve, which is a sorted list of (place, value), or None
    outside of it; without `interpolate`, between its points, too."""
    after = bisect.bisect_left(curve, (place - tolerance,))
    if after == len(curve):
        return None
    x1, y1 = curve[after]
    if x1 <= place + tolerance:
        return y1
    if after == 0 or not interpolate:
        return None
    x0, y0 = curve[after - 1]
    return y0 + (y1 - y0) * (place - x0) / (x1 - x0)


def tolerance_of(curves):
    """Within which places are the same."""
    places = [place for curve in curves.values() for place, _ in curve]
    return SAME * (max(places) - min(places)) if places else 0.0


def _thinned(places):
    """At most MOST_PLACES of them, with the first and the last."""
    if len(places) <= MOST_PLACES:
        return places
    step = (len(places) - 1) / (MOST_PLACES - 1)
    return [places[round(step * number)] for number in range(MOST_PLACES)]


def _shared(sorted_places, tolerance):
    """The places at which at least FEWEST of the curves have a point."""
    shared, begin = [], 0
    for end in range(1, len(sorted_places) + 1):
        if (end == len(sorted_places) or
                sorted_places[end] - sorted_places[begin] > tolerance):
            if end - begin >= FEWEST:
                shared.append(sorted_places[begin])
            begin = end
    return shared


def places_of(curves, interpolate=True):
    """Where curves, {name: sorted list of (place, value)}, are compared."""
    places = sorted(place for curve in curves.values() for place, _ in curve)
    if not places:
        return []
    shared = _shared(places, tolerance_of(curves))
    if shared or not interpolate:
        return _thinned(shared)
    low, high = places[0], places[-1]
    step = (high - low) / (MOST_PLACES - 1)
    return [low + step * number for number in range(MOST_PLACES)]


def _deviation(values, median):
    return SCALE * statistics.median(abs(value - median) for value in values)


def _values(curves, interpolate):
    """[(place, {name: value}, median)], where enough curves have a value."""
    tolerance, found = tolerance_of(curves), []
    for place in places_of(curves, interpolate):
        values = {name: value_at(curve, place, tolerance, interpolate)
                  for name, curve in curves.items()}
        values = {name: value for name, value in values.items()
                  if value is not None}
        if len(values) >= FEWEST:
            found.append((place, values, statistics.median(values.values())))
    return found


def find(curves, interpolate=True):
    """The outliers of curves, {name: sorted list of (place, value)}, each where it
    is farthest out, the farthest first."""
    compared = _values(curves, interpolate)
    least = LEAST_SHARE * max((abs(median) for _, _, median in compared), default=0)
    worst = {}
    for place, values, median in compared:
        allowed = max(LIMIT * _deviation(values.values(), median), least)
        for name, value in values.items():
            distance = abs(value - median)
            if distance <= allowed:
                continue
            excess = distance / allowed if allowed else math.inf
            if name not in worst or excess > worst[name].excess:
                worst[name] = Outlier(name, place, value, median, excess)
    return sorted(worst.values(), key=lambda each: (-each.excess, each.name))


def medians(curves, interpolate=True):
    """The curve of the group's median, where it is compared."""
    return [(place, median) for place, _, median in _values(curves, interpolate)]


def ranges(curves, interpolate=True):
    """[(place, smallest, largest)] of curves, where they are compared."""
    return [(place, min(values.values()), max(values.values()))
            for place, values, _ in _values(curves, interpolate)]
