# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""What report.json says of the muscles of a run, over its usable frames: lengths of
lines, moment arms and volumes, as curves that can be compared over subjects."""
import dataclasses

VOLUME, LENGTH, MOMENT_ARM = "volume", "length", "moment arm"
MM3_PER_CM3 = 1000.0
FRAME = "frame"  # the axis where not exactly one coordinate moves


@dataclasses.dataclass(frozen=True, order=True)
class Quantity:
    """What is compared of a muscle."""

    muscle: str
    kind: str  # VOLUME (at rest), LENGTH or MOMENT_ARM
    line: str = ""  # "" of a volume
    coordinate: str = ""  # of a moment arm
    unit: str = ""

    def title(self):
        """What it is, without its muscle."""
        of = {VOLUME: "", LENGTH: f" of {self.line}",
              MOMENT_ARM: f" of {self.line} about {self.coordinate}"}
        return f"{self.kind}{of[self.kind]}"


@dataclasses.dataclass
class Measured:
    """A run, of which only usable frames are here."""

    participant: str
    motion: str
    # {name: unit} of the coordinates that the motion moves
    moving: dict = dataclasses.field(default_factory=dict)
    # {index of a frame: {coordinate: value}}
    frames: dict = dataclasses.field(default_factory=dict)
    muscles: tuple = ()
    # {Quantity: value}: cm3
    volumes: dict = dataclasses.field(default_factory=dict)
    # {Quantity: {index of a frame: value}}: mm, or mm/rad or mm/m
    curves: dict = dataclasses.field(default_factory=dict)


@dataclasses.dataclass(frozen=True)
class Axis:
    """What the curves of a motion are drawn over."""

    name: str = FRAME  # or a coordinate
    unit: str = ""  # of the coordinate

    @property
    def is_frame(self):
        return not self.unit

    def label(self):
        return self.name if self.is_frame else f"{self.name}, {self.unit}"


def _unit_of_arms(coordinate, units):
    """Reports tell the units of coordinates that a motion gives; others are taken
    for angles."""
    return "mm/m" if units.get(coordinate) == "metres" else "mm/rad"


def _add_frame(curves, frame, units):
    """Adds the lengths and moment arms of a frame."""
    arms_hold = frame.get("moment_arms_converged", True)
    for muscle in frame["muscles"]:
        name, values = muscle["name"], {}
        for line, length in muscle.get("line_lengths_mm", {}).items():
            values[Quantity(name, LENGTH, line, unit="mm")] = length
        for line, arms in muscle.get("line_moment_arms_mm", {}).items():
            for coordinate, arm in arms.items() if arms_hold else ():
                unit = _unit_of_arms(coordinate, units)
                values[Quantity(name, MOMENT_ARM, line, coordinate, unit)] = arm
        for quantity, value in values.items():
            if value is not None:  # the shape could not be differentiated
                curves.setdefault(quantity, {})[frame["index"]] = value


def of_report(participant, motion, report):
    """The Measured of a run; without frames if `report` is None or has no usable
    ones. LookupError, TypeError or AttributeError if it is no report."""
    measured = Measured(participant, motion)
    usable = [frame for frame in (report or {}).get("frames", [])
              if frame["usable"]]
    if not usable:
        return measured
    coordinates = (report.get("motion") or {}).get("coordinates", [])
    units = {each["name"]: each["unit"] for each in coordinates}
    measured.moving = {each["name"]: each["unit"] for each in coordinates
                       if each["moves"]}
    measured.muscles = tuple(m["name"] for m in report["prepare"]["muscles"])
    measured.volumes = {
        Quantity(m["name"], VOLUME, unit="cm3"): m["volume_mm3"] / MM3_PER_CM3
        for m in report["prepare"]["muscles"] if m.get("volume_mm3") is not None}
    for frame in usable:
        measured.frames[frame["index"]] = frame.get("coordinates") or {}
        _add_frame(measured.curves, frame, units)
    return measured


def _is_monotonic(values):
    steps = [after - before for before, after in zip(values, values[1:])]
    return all(step > 0 for step in steps) or all(step < 0 for step in steps)


def axis_of(runs):
    """The coordinate, if it alone moves in every run, and always in one direction,
    so that a value of it is one frame; the frames otherwise. Runs without frames
    have no say."""
    runs = [run for run in runs if run.frames]
    found = {next(iter(run.moving.items())) if len(run.moving) == 1 else None
             for run in runs}
    if len(found) != 1 or None in found:
        return Axis()
    name, unit = found.pop()
    for run in runs:
        values = [run.frames[index].get(name) for index in sorted(run.frames)]
        if None in values or not _is_monotonic(values):
            return Axis()
    return Axis(name, unit)


def points(run, quantity, axis):
    """The curve of a run as (value of the axis, value), in the order of the axis;
    [] if the run does not have it."""
    values = run.curves.get(quantity, {})
    return sorted((index if axis.is_frame else run.frames[index][axis.name], value)
                  for index, value in values.items())
