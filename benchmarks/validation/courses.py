# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""How a muscle lengthens and thickens over the motion of a run."""

import numpy as np

import sections


class Course:
    """How long a muscle is over a motion, and its sections; angles ascend, with
    the sign of the literature."""

    def __init__(self, run, muscle, sign=1):
        order = np.argsort(sign * run.angles)
        self.run, self.muscle, self.order = run, muscle, order
        self.angles = sign * run.angles[order]
        self.lengths = self._means("line_lengths_mm")  # from end to end
        self.fibres = self._means("fibre_lengths_mm")
        self.paths = self._means("path_lengths_mm")

    def _figures(self):
        for frame in np.array(self.run.frames)[self.order]:
            yield next(m for m in frame["muscles"] if m["name"] == self.muscle)

    def _means(self, key):
        found = [figures[key] for figures in self._figures()]
        listed = [list(f.values()) if isinstance(f, dict) else f for f in found]
        return np.array([np.mean(values_) for values_ in listed])

    def change(self, start, end, fibres=False):
        """The change of length from one angle to another, or that of fibres."""
        lengths = self.fibres if fibres else self.lengths
        first, last = np.interp([start, end], self.angles, lengths)
        return last - first

    def gear(self):
        """How much the muscle lengthens when its whole path does by 1."""
        return np.ptp(self.lengths) / np.ptp(self.paths)

    def volume_change(self):
        return max(abs(figures["volume_ratio"] - 1) for figures in self._figures())

    def largest_sections(self):
        """In each frame the largest section, mm², and how far from the upper
        end it is."""
        lines = list(self.run.lines[self.muscle].values())
        start, end = np.mean([line[[0, -1]] for line in lines], axis=0)
        found = []
        for folder in np.array(self.run.frame_folders())[self.order]:
            lines = self.run.lines_file(folder)[self.muscle]["lines"]
            middle = sections.middle_line([line["points"] for line in lines])
            if start[2] < end[2]:
                middle = middle[::-1]
            mesh = self.run.mesh(folder, self.muscle)
            along, areas = sections.areas_along(*mesh, middle)
            found.append((areas.max(), sections.peak_of(along, areas)))
        return np.array(found).T
