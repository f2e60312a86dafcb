# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""People with bones and reference joints, runs of musclewarp-articulate on them, and
how far the joints found are off."""

from __future__ import annotations

import dataclasses
import json
import math
import pathlib
import subprocess
import tempfile
from typing import Callable, Mapping

import numpy as np
from bone_variants import Mesh, moved, read_mesh, write_mesh

KINDS = ("hip", "knee", "ankle", "subtalar")
OTHER_SIDE = {"r": "l", "l": "r"}

# A joint that is farther off is wrong: mm of a hip; degrees and mm of an axis. Good
# methods differ by 11 degrees at the subtalar joint.
WRONG = {
    "hip": (5.0,),
    "knee": (5.0, 10.0),
    "ankle": (5.0, 10.0),
    "subtalar": (15.0, 10.0),
}

Bones = Mapping[str, Mesh]


@dataclasses.dataclass(frozen=True)
class Reference:
    """A joint as another program or an earlier fit has it."""

    point: np.ndarray
    direction: np.ndarray | None = None  # none of a hip
    frames: tuple[np.ndarray, np.ndarray] | None = None  # of a hip: pelvis, femur

    def moved(self, matrix: np.ndarray) -> Reference:
        turn = matrix[:3, :3]
        to_right = np.diag([1.0, 1.0, np.sign(np.linalg.det(turn))])
        return Reference(
            turn @ self.point + matrix[:3, 3],
            None if self.direction is None else turn @ self.direction,
            self.frames
            and (turn @ self.frames[0] @ to_right, turn @ self.frames[1] @ to_right),
        )


@dataclasses.dataclass(frozen=True)
class Leg:
    """The bones of one leg and the pelvis, by names without side."""

    person: str
    side: str  # r or l
    bones: Bones
    references: Mapping[str, Reference]

    @property
    def name(self) -> str:
        return f"{self.person} {self.side}"

    def changed(self, change: Callable[[Mesh], Mesh]) -> Leg:
        bones = {name: change(mesh) for name, mesh in self.bones.items()}
        return dataclasses.replace(self, bones=bones)

    def moved(self, matrix: np.ndarray) -> Leg:
        """The leg elsewhere; a mirrored one is of the other side."""
        side = OTHER_SIDE[self.side] if np.linalg.det(matrix[:3, :3]) < 0 else self.side
        references = {kind: ref.moved(matrix) for kind, ref in self.references.items()}
        leg = self.changed(lambda mesh: moved(mesh, matrix))
        return dataclasses.replace(leg, side=side, references=references)

    def with_bones(self, **bones: Mesh) -> Leg:
        return dataclasses.replace(self, bones={**self.bones, **bones})

    def together_with(self, other: Leg) -> dict[str, Mesh]:
        """The bones of both legs by names with side."""
        return {**other.named(), **self.named()}

    def named(self) -> dict[str, Mesh]:
        """The bones by names with side."""
        return {
            name if name.startswith("pelvis") else f"{name}_{self.side}": mesh
            for name, mesh in self.bones.items()
        }


@dataclasses.dataclass(frozen=True)
class Found:
    """A joint of a run; of one that failed there is no more than the reasons."""

    side: str
    quality: str
    reasons: tuple[str, ...]
    center: np.ndarray
    axis: np.ndarray  # of its first coordinate
    frames: tuple[np.ndarray, np.ndarray]


@dataclasses.dataclass(frozen=True)
class Run:
    exit_code: int
    message: str
    joints: Mapping[str, Found]  # by kind and side: hip_r

    def joint(self, kind: str, side: str) -> Found | None:
        """The joint of a side, else that of the other."""
        own = self.joints.get(f"{kind}_{side}")
        return own or self.joints.get(f"{kind}_{OTHER_SIDE[side]}")

    def sides(self) -> str:
        return "".join(sorted({joint.side for joint in self.joints.values()}))


def _reference_of(joint: dict) -> Reference:
    if "direction" not in joint:
        frames = tuple(np.array(joint[key]) for key in ("parent_axes", "child_axes"))
        return Reference(np.array(joint["center"]), frames=(frames[0], frames[1]))
    return Reference(np.array(joint["point"]), np.array(joint["direction"]))


def read_legs(folder: pathlib.Path, person: str) -> list[Leg]:
    """The legs of a person of data/joints."""
    record = json.loads((folder / "joints_reference.json").read_text())
    meshes = {
        path.stem: read_mesh(path)
        for path in sorted(folder.glob("*.ply"))
        if "no_fib" not in path.stem
    }
    legs = []
    for side in ("r", "l"):
        references = {
            name[:-2]: _reference_of(joint)
            for name, joint in record["joints"].items()
            if name.endswith("_" + side)
        }
        bones = {
            name.removesuffix("_" + side): mesh
            for name, mesh in meshes.items()
            if name.endswith("_" + side) or name.startswith("pelvis")
        }
        if references:
            legs.append(Leg(person, side, bones, references))
    return legs


def read_body_parts(folder: pathlib.Path, kind: str = "") -> Leg:
    """The right leg of BodyParts3D: repaired meshes, or those of a folder of them."""
    record = json.loads((folder / "joints.json").read_text())
    bones = {}
    for name in ("femur", "tibia", "hip_bone"):
        path = folder / kind / f"{name}.obj"
        path = path if path.exists() else folder / f"{name}.obj"
        bones[name] = read_mesh(path)
    references = {
        "hip": Reference(np.array(record["hip_r"]["center"])),
        "knee": Reference(
            np.array(record["knee_r"]["point"]),
            np.array(record["knee_r"]["direction_lateral_to_medial"]),
        ),
    }
    return Leg(" ".join(["BodyParts3D", kind]).strip(), "r", bones, references)


def _found_of(joint: dict) -> Found:
    verdict = joint["name"][-1], joint["quality"], tuple(joint["reasons"])
    if joint["quality"] == "failed":
        return Found(*verdict, np.zeros(3), np.zeros(3), (np.eye(3), np.eye(3)))
    return Found(
        *verdict,
        np.array(joint["center_mm"]),
        np.array(joint["coordinates"][0]["axis"]),
        (np.array(joint["parent_axes"]), np.array(joint["child_axes"])),
    )


def articulate(program: pathlib.Path, bones: Bones, flags: list[str]) -> Run:
    """Runs the program on meshes written to files of their names."""
    with tempfile.TemporaryDirectory() as folder:
        files = [pathlib.Path(folder) / f"{name}.ply" for name in bones]
        for path, mesh in zip(files, bones.values()):
            write_mesh(mesh, path)
        out = pathlib.Path(folder) / "out"
        command = [program, f"--out={out}", "--threads=1", *flags, *files]
        done = subprocess.run(
            [str(part) for part in command], capture_output=True, text=True, timeout=300
        )
        joints = {}
        if (out / "joints.json").exists():
            record = json.loads((out / "joints.json").read_text())
            joints = {joint["name"]: _found_of(joint) for joint in record["joints"]}
        message = done.stderr.replace(f"{folder}/", "")
        message = message.removeprefix(f"{program.name}: ").strip()
        return Run(done.returncode, message, joints)


def degrees_between(a: np.ndarray, b: np.ndarray) -> float:
    """Between two lines."""
    cosine = abs(a @ b) / np.linalg.norm(a) / np.linalg.norm(b)
    return math.degrees(math.acos(min(1.0, cosine)))


def turn_between(a: np.ndarray, b: np.ndarray) -> float:
    """Between two frames, degrees."""
    cosine = (np.trace(a.T @ b) - 1) / 2
    return math.degrees(math.acos(min(1.0, max(-1.0, cosine))))


def distance_from_axis(
    point: np.ndarray, on_axis: np.ndarray, axis: np.ndarray
) -> float:
    way = np.cross(point - on_axis, axis / np.linalg.norm(axis))
    return float(np.linalg.norm(way))


def differences(found: Found, reference: Reference) -> tuple[float, ...]:
    """mm of a hip; degrees and mm of an axis."""
    if reference.direction is None:
        return (float(np.linalg.norm(found.center - reference.point)),)
    return (
        degrees_between(found.axis, reference.direction),
        distance_from_axis(reference.point, found.center, found.axis),
    )


def is_wrong(kind: str, found: Found, reference: Reference) -> bool:
    off = differences(found, reference)
    return any(value > limit for value, limit in zip(off, WRONG[kind]))
