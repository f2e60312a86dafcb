#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Measures how far the joints of musclewarp-articulate are off reference joints.

  benchmarks/joint_accuracy.py PROGRAM DATA [--out=TABLE.md] [--only=TEXT]

DATA has the folders joints and bodyparts3d. The bones of each leg are taken as they
are, turned, mirrored, decimated, made anew from voxels and damaged, each time in files
whose names do not tell the side; then parts of bones, wrong bones and bones of two
scans, of which a joint must not be called good. Prints tables in Markdown, the limits
that do not hold, wrong joints that are called good and whole joints that are called
failed. Exit code: 0 if all limits and expectations hold, 1 if not.

Needs the python3-numpy and python3-vtk9 of Debian; takes some five minutes of one core.
"""

from __future__ import annotations

import argparse
import dataclasses
import pathlib
import sys
import time
from typing import Callable, Iterator

import bone_variants as variants
from joint_failures import WEAK, failure_cases, is_met, verdict
from joint_runs import (
    KINDS,
    OTHER_SIDE,
    Found,
    Leg,
    Run,
    articulate,
    differences,
    is_wrong,
    read_body_parts,
    read_legs,
    turn_between,
)

SEEDS = (1, 2, 3)

# Differences that are allowed, of all legs and of those with a talus from CT.
Limits = dict[str, tuple[float, ...]]
LIMITS: Limits = {"hip": (1.0,), "knee": (1.5, 3.5)}
LIMITS_OF_CT: Limits = {**LIMITS, "ankle": (2.0, 2.0), "subtalar": (6.0,)}
LIMITS_OF_VARIANTS: Limits = {"hip": (1.5,), "knee": (2.0,)}
LIMITS_OF_CT_VARIANTS: Limits = {**LIMITS_OF_VARIANTS, "ankle": (2.0,)}
CT = "LHDL_CT"


@dataclasses.dataclass(frozen=True)
class Variant:
    name: str
    leg: Leg
    flags: tuple[str, ...] = ()
    has_limits: bool = False
    with_side: bool = False  # in the names of the files
    other_leg: Leg | None = None  # in the same run


@dataclasses.dataclass
class Findings:
    """What is not as it should be, a line each."""

    limits: list[str] = dataclasses.field(default_factory=list)
    wrong_good: list[str] = dataclasses.field(default_factory=list)
    wrong_weak: list[str] = dataclasses.field(default_factory=list)
    failed: list[str] = dataclasses.field(default_factory=list)
    unexpected: list[str] = dataclasses.field(default_factory=list)

    def of_wrong(self, found: Found) -> list[str]:
        return self.wrong_good if found.quality == "good" else self.wrong_weak


def variants_of(leg: Leg, legs: list[Leg]) -> Iterator[Variant]:
    yield Variant("as it is", leg, has_limits=True)
    for other in legs:
        if (other.person, other.side) == (leg.person, OTHER_SIDE[leg.side]):
            yield Variant("named, with the other leg", leg, (), True, True, other)
    yield Variant("named by side", leg, has_limits=True, with_side=True)
    for seed in SEEDS:
        turned = leg.moved(variants.random_motion(seed))
        yield Variant(f"turned {seed}", turned, ("--axes=none",), has_limits=True)
    turned = leg.moved(variants.random_motion(SEEDS[0]))
    flags = ("--axes=none",)
    yield Variant("turned, named by side", turned, flags, True, with_side=True)
    mirrored = leg.moved(variants.MIRROR)
    yield Variant("mirrored", mirrored, has_limits=True)
    yield Variant("mirrored, no axes", mirrored, ("--axes=none",), has_limits=True)
    for count in (2000, 500):
        coarse = leg.changed(lambda mesh: variants.decimated(mesh, count))
        yield Variant(f"{count} triangles", coarse, has_limits=count == 2000)
    for size in (1.0, 1.5, 3.0):
        stairs = leg.changed(lambda mesh: variants.from_voxels(mesh, size))
        yield Variant(f"voxels {size:g} mm", stairs, has_limits=size == 1.5)
        yield Variant(
            f"voxels {size:g} mm, smoothed",
            stairs.changed(variants.smoothed),
            has_limits=size == 1.5,
        )
    change: Callable[[variants.Mesh], variants.Mesh]
    for name, change in (
        ("noise 0.5 mm", lambda mesh: variants.noisy(mesh, 0.5, 1)),
        ("triangles inverted", variants.inverted),
        ("5 % of triangles removed", lambda mesh: variants.with_holes(mesh, 0.05, 1)),
    ):
        yield Variant(name, leg.changed(change))


def limits_of(variant: Variant) -> Limits:
    if not variant.has_limits:
        return {}
    is_ct = variant.leg.person == CT
    if variant.name.startswith(("as it is", "named", "mirrored")):
        return LIMITS_OF_CT if is_ct else LIMITS
    return LIMITS_OF_CT_VARIANTS if is_ct else LIMITS_OF_VARIANTS


def side_cell(variant: Variant, run: Run, findings: Findings) -> str:
    sides = run.sides()
    if variant.other_leg and sides == "lr":
        return "both"
    if sides == variant.leg.side:
        return sides
    where = f"{variant.leg.name}, {variant.name}"
    findings.limits.append(f"{where}: side {sides or 'none'}, is {variant.leg.side}")
    return f"**{sides or 'none'}**"


def joint_cell(variant: Variant, run: Run, kind: str, findings: Findings) -> str:
    where = f"{variant.leg.name}, {variant.name}: {kind}"
    reference = variant.leg.references.get(kind)
    if reference is None:
        return ""
    found = run.joint(kind, variant.leg.side)
    limits = limits_of(variant).get(kind, ())
    if found is None or found.quality == "failed":
        reason = "; ".join(found.reasons) if found else run.message or "not there"
        findings.failed.append(f"{where}: {reason}")
        if limits:
            findings.limits.append(f"{where} failed")
        return "failed" if found else "none"
    off = differences(found, reference)
    text = ", ".join(f"{value:.1f}" for value in off)
    if any(value > limit for value, limit in zip(off, limits)):
        allowed = ", ".join(f"{limit:g}" for limit in limits)
        findings.limits.append(f"{where} {text}, {allowed} allowed")
    if is_wrong(kind, found, reference):
        findings.of_wrong(found).append(f"{where} {text}")
        text = f"**{text}**"
    return text + (" weak" if found.quality == "weak" else "")


def frames_cell(variant: Variant, run: Run) -> str:
    """Turns between the frames of pelvis and femur and those of the reference."""
    found, reference = run.joint("hip", variant.leg.side), variant.leg.references["hip"]
    if found is None or found.quality == "failed" or reference.frames is None:
        return ""
    return ", ".join(
        f"{turn_between(own, other):.1f}"
        for own, other in zip(found.frames, reference.frames)
    )


def row(cells: list[str]) -> str:
    return "| " + " | ".join(cell.replace("|", "/") for cell in cells) + " |"


def header(cells: list[str]) -> list[str]:
    return [row(cells), "|" + "---|" * len(cells)]


def variant_row(program: pathlib.Path, variant: Variant, findings: Findings) -> str:
    leg = variant.leg
    bones = leg.named() if variant.with_side else leg.bones
    if variant.other_leg:
        bones = leg.together_with(variant.other_leg)
    run = articulate(program, bones, list(variant.flags))
    cells = [joint_cell(variant, run, kind, findings) for kind in KINDS]
    side = side_cell(variant, run, findings)
    return row([leg.name, variant.name, *cells, frames_cell(variant, run), side])


def variant_table(
    program: pathlib.Path,
    legs: list[Leg],
    others: list[Leg],
    only: str,
    findings: Findings,
) -> Iterator[str]:
    yield from header([
        "leg", "variant", "hip, mm", *(f"{kind}, deg, mm" for kind in KINDS[1:]),
        "frames of pelvis and femur, deg", "side",
    ])  # fmt: skip
    for leg in legs:
        for variant in variants_of(leg, legs):
            if only in variant.name:
                yield variant_row(program, variant, findings)
    for leg in others:
        if only in "as it is":
            yield variant_row(program, Variant("as it is", leg, (), True), findings)


def failure_table(
    program: pathlib.Path, legs: list[Leg], only: str, findings: Findings
) -> Iterator[str]:
    yield from header(["leg", "bones", "expected", "got", ""])
    cases = [case for case in failure_cases(legs) if only in case.what]
    for case in cases:
        run = articulate(program, case.bones, case.flags)
        met, got = is_met(case, run), verdict(case, run)
        where = f"{case.leg.name}, {case.what}"
        if not met:
            findings.unexpected.append(
                f"{where}: {got}, expected {case.expectation()}"
            )
        for kind in case.expected:
            found = run.joint(kind, case.leg.side)
            if found is None or found.quality == "failed":
                continue
            if case.expected[kind] == WEAK and found.quality == "weak":
                continue
            wrong_side = found.side != case.leg.side
            if wrong_side or is_wrong(kind, found, case.leg.references[kind]):
                findings.of_wrong(found).append(f"{where}: {got}")
        mark = "" if met else "**no**"
        yield row([case.leg.name, case.what, case.expectation(), got, mark])


def finding_lists(findings: Findings) -> Iterator[str]:
    for title, lines in (
        ("Limits that do not hold", findings.limits),
        ("Wrong joints called good", findings.wrong_good),
        ("Wrong joints called weak", findings.wrong_weak),
        ("Joints of whole bones called failed", findings.failed),
        ("Verdicts that are not as expected", findings.unexpected),
    ):
        yield f"\n## {title}\n"
        yield from ("- " + " ".join(line.split()) for line in lines or ["none"])


def tables(arguments: argparse.Namespace, findings: Findings) -> Iterator[str]:
    data = arguments.data
    legs = [
        *read_legs(data / "joints" / CT, CT),
        *read_legs(data / "joints" / "TLEM2_MRI", "TLEM2_MRI"),
        read_body_parts(data / "bodyparts3d"),
    ]
    kinds = ("raw", "uniform")
    others = [read_body_parts(data / "bodyparts3d", kind) for kind in kinds]
    program, only = arguments.program, arguments.only
    yield "# Joints found and reference joints\n"
    yield (
        "Hip: distance of the centres. Axes: angle, and distance of the reference "
        "point from the axis found. Bold: wrong.\n"
    )
    yield from variant_table(program, legs, others, only, findings)
    yield "\n## Parts of bones, wrong bones, bones of two scans\n"
    yield (
        "Right: found and not wrong; honest: failed, or not wrong. Hip: mm; axes: "
        "degrees and mm.\n"
    )
    yield from failure_table(program, legs, only, findings)
    yield from finding_lists(findings)


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, help="file for the tables")
    parser.add_argument("--only", default="", help="part of the names of the variants")
    arguments = parser.parse_args()
    start, findings, lines = time.monotonic(), Findings(), []
    for line in tables(arguments, findings):
        print(line, flush=True)
        lines.append(line)
    if arguments.out:
        arguments.out.write_text("\n".join(lines) + "\n")
    print(f"{time.monotonic() - start:.0f} s", file=sys.stderr)
    return int(bool(findings.limits or findings.wrong_good or findings.unexpected))


if __name__ == "__main__":
    sys.exit(main())
