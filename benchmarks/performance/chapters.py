# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Chapters of a page that scripts write, between markers."""


def markers(name, script="benchmarks/performance.sh"):
    """The lines before and after a chapter that a script writes."""
    begin = f"<!-- {name}: written by {script}; do not edit. -->"
    return begin, f"<!-- End of {name.lower()}. -->"


def replaced(text, name, parts, script="benchmarks/performance.sh"):
    """The text with these parts between the markers of a chapter."""
    begin, end = markers(name, script)
    if text.count(begin) != 1 or text.count(end) != 1:
        raise ValueError(f"the page needs once: {begin} and {end}")
    before, rest = text.split(begin)
    inside, after = rest.split(end)
    if end in before:
        raise ValueError(f"the page has {end} before {begin}")
    return "\n\n".join([before + begin, *parts, end + after])
