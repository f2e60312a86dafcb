# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Bones that are cut, swapped, moved or none, and what has to be said of them."""

from __future__ import annotations

import dataclasses
from typing import Iterator, Mapping

import bone_variants as variants
import numpy as np
from joint_runs import Bones, Found, Leg, Run, differences, is_wrong

# What may be said of a joint. "right" is found and not wrong, "honest" failed or not
# wrong, "weak" anything but good.
FAILED, RIGHT, HONEST, WEAK = "failed", "right", "honest", "not good"
EXIT_2 = "exit 2"


@dataclasses.dataclass(frozen=True)
class Case:
    what: str
    leg: Leg
    bones: Bones  # by names with or without side
    flags: list[str]
    expected: Mapping[str, str]  # by kind of joint
    exit_2: bool = False  # expected

    def expectation(self) -> str:
        if self.exit_2:
            return EXIT_2
        return ", ".join(f"{kind} {what}" for kind, what in self.expected.items())


def _without_talus(leg: Leg) -> Leg:
    """The bones of hip and knee."""
    keeps = {
        name: mesh
        for name, mesh in leg.bones.items()
        if name.startswith(("pelvis", "hip", "femur", "tibia"))
    }
    return dataclasses.replace(leg, bones=keeps)


def _up(leg: Leg) -> np.ndarray:
    way = leg.references["hip"].point - leg.references["knee"].point
    return way / np.linalg.norm(way)


def _towards_head(leg: Leg) -> np.ndarray:
    """Medial and up, 45 degrees from the shaft; x is to the left of the body."""
    up = _up(leg)
    medial = np.array([1.0 if leg.side == "r" else -1.0, 0, 0])
    medial -= medial @ up * up
    way = up + medial / np.linalg.norm(medial)
    return way / np.linalg.norm(way)


def _at_height(leg: Leg, share: float) -> np.ndarray:
    """A point at a share of the height of the femur."""
    heights = leg.bones["femur"].points @ _up(leg)
    height = heights.min() + share * (heights.max() - heights.min())
    knee = leg.references["knee"].point
    return knee + (height - knee @ _up(leg)) * _up(leg)


def _case(
    what: str, leg: Leg, expected: dict[str, str], *flags: str, exit_2: bool = False
) -> Case:
    return Case(what, leg, leg.named(), list(flags), expected, exit_2)


def _cut_femora(leg: Leg) -> Iterator[Case]:
    femur = leg.bones["femur"]
    for share in (0.75, 0.5, 0.25):
        for closed in (True, False):
            part = variants.cut(femur, _at_height(leg, 1 - share), -_up(leg), closed)
            yield _case(
                f"upper {100 * share:.0f} % of the femur{'' if closed else ', open'}",
                leg.with_bones(femur=part),
                {"hip": RIGHT, "knee": FAILED},
            )
        yield Case(
            f"upper {100 * share:.0f} % of the femur, names without side",
            leg,
            leg.with_bones(femur=part).bones,
            [],
            {"hip": HONEST, "knee": FAILED},
        )
    side = f"--side={'right' if leg.side == 'r' else 'left'}"
    for share in (0.5, 0.25, 0.15):
        part = variants.cut(femur, _at_height(leg, share), _up(leg))
        for axes, knee in (("LPS", RIGHT), ("none", HONEST)):
            yield _case(
                f"lower {100 * share:.0f} % of the femur, axes {axes}",
                leg.with_bones(femur=part),
                {"hip": FAILED, "knee": knee},
                side,
                f"--axes={axes}",
            )


def _cut_heads(leg: Leg) -> Iterator[Case]:
    center, way = leg.references["hip"].point, _towards_head(leg)
    femur = leg.bones["femur"]
    radius = 23.0  # of the shared people, within 0.3 mm
    for share, hip in ((0.7, RIGHT), (0.5, HONEST), (0.3, HONEST), (0, HONEST)):
        part = variants.cut(femur, center + share * radius * way, way)
        yield _case(
            f"head cut {share} radii from its centre",
            leg.with_bones(femur=part),
            {"hip": hip, "knee": RIGHT},
        )
    part = variants.cut(femur, center - radius * way, way)
    yield _case(
        "head removed", leg.with_bones(femur=part), {"hip": FAILED, "knee": HONEST}
    )


def _moved_femora(leg: Leg) -> Iterator[Case]:
    lateral = -1.0 if leg.side == "r" else 1.0
    for what, shift in (
        ("20 mm lateral", (20 * lateral, 0, 0)),
        ("20 mm medial", (-20 * lateral, 0, 0)),
        ("20 mm down", (0, 0, -20)),
        ("100 mm down", (0, 0, -100)),
    ):
        matrix = np.eye(4)
        matrix[:3, 3] = shift
        yield _case(
            f"femur moved {what}",
            leg.with_bones(femur=variants.moved(leg.bones["femur"], matrix)),
            {"hip": WEAK},
        )
    around_head = np.eye(4)
    around_head[:3, 3] = leg.references["hip"].point
    mirrored = around_head @ variants.MIRROR @ np.linalg.inv(around_head)
    yield _case(
        "femur mirrored, name kept",
        leg.with_bones(femur=variants.moved(leg.bones["femur"], mirrored)),
        {},
        exit_2=True,
    )


def _wrong_units(leg: Leg) -> Iterator[Case]:
    small = np.diag([0.001, 0.001, 0.001, 1.0])
    failed = {"hip": FAILED, "knee": FAILED}
    yield _case("all bones in m", leg.moved(small), failed)
    femur = variants.moved(leg.bones["femur"], small)
    yield _case("femur in m", leg.with_bones(femur=femur), failed)
    cm = np.diag([0.1, 0.1, 0.1, 1.0])
    yield _case("all bones in cm", leg.moved(cm), failed)


def _no_femora(leg: Leg) -> Iterator[Case]:
    center = leg.references["hip"].point
    none = {"hip": WEAK, "knee": FAILED}
    for what, mesh in (
        ("a sphere of 25 mm", variants.sphere(center, 25)),
        ("a sphere of 100 mm", variants.sphere(center, 100)),
        ("a box", variants.box(center - [25, 25, 400], center + [25, 25, 25])),
        ("the tibia", leg.bones["tibia"]),
        ("the pelvis", next(m for n, m in leg.bones.items() if n[0] in "ph")),
    ):
        yield _case(f"{what} named femur", leg.with_bones(femur=mesh), none)


def _no_bones(leg: Leg) -> Iterator[Case]:
    yield Case("no files", leg, {}, [], {}, exit_2=True)
    femur = leg.bones["femur"]
    yield Case("unknown names", leg, {"a": femur, "b": femur}, [], {}, exit_2=True)
    empty = variants.Mesh(np.zeros((0, 3)), np.zeros((0, 3), np.int64))
    yield _case(
        "femur without triangles", leg.with_bones(femur=empty), {}, exit_2=True
    )


def _swapped(right: Leg, left: Leg) -> Iterator[Case]:
    for leg, other in ((right, left), (left, right)):
        yield _case(
            "tibia of the other leg",
            leg.with_bones(tibia=other.bones["tibia"]),
            {"knee": WEAK, "ankle": FAILED},
        )
        yield _case(
            "talus of the other leg",
            leg.with_bones(talus=other.bones["talus"]),
            {"ankle": FAILED, "subtalar": FAILED},
        )


def failure_cases(legs: list[Leg]) -> Iterator[Case]:
    """All cases, of legs that are as they are."""
    for leg in map(_without_talus, legs):
        yield from _cut_femora(leg)
        yield from _cut_heads(leg)
        yield from _moved_femora(leg)
    first = _without_talus(legs[0])
    yield from _wrong_units(first)
    yield from _no_femora(first)
    yield from _no_bones(first)
    for right in legs:
        for left in legs:
            if (right.person, right.side, left.side) == (left.person, "r", "l"):
                yield from _swapped(right, left)


def _is_met(case: Case, kind: str, found: Found | None) -> bool:
    what = case.expected[kind]
    if found is None or found.quality == "failed":
        return what != RIGHT
    if what == WEAK:
        return found.quality == "weak"
    is_right = not is_wrong(kind, found, case.leg.references[kind])
    return what != FAILED and is_right and found.side == case.leg.side


def is_met(case: Case, run: Run) -> bool:
    if case.exit_2:
        return run.exit_code == 2 and run.message != ""
    return run.exit_code in (0, 1, 2) and all(
        _is_met(case, kind, run.joint(kind, case.leg.side)) for kind in case.expected
    )


def verdict(case: Case, run: Run) -> str:
    """What was said of the joints that the case is about."""
    if run.exit_code not in (0, 1):
        return f"exit {run.exit_code}: " + " ".join(run.message.split())[:120]
    parts = []
    for kind in case.expected or ("hip", "knee"):
        found = run.joint(kind, case.leg.side)
        if found is None:
            parts.append(f"no {kind}")
            continue
        text = f"{kind} {found.quality}"
        if found.side != case.leg.side:
            text = f"{kind} of the other side {found.quality}"
        if found.quality != "failed" and case.expected.get(kind) != WEAK:
            off = differences(found, case.leg.references[kind])
            units = ("mm",) if len(off) == 1 else ("deg", "mm")
            text += "".join(f" {value:.1f} {u}" for value, u in zip(off, units))
        parts.append(text)
    return ", ".join(parts)
