#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs two builds of musclewarp-deform on the same scenes, by turns, and says
how far their results differ: a change of the code that is to change no result
is shown by "identical" in every row.

  scripts/compare_builds.py --before=DIR --after=DIR --data_root=DATA --out=DIR

DIR of a build holds its programs, such as build/release/tools. Scenes of public
data are left out without --data_root. For every scene a row says how many
frames are usable, how many mesh files differ by a byte and by how much the
points in them differ at most (mm), and the medians of the times per frame and
of the preparation (ms). Exit code: 0 if nothing differs by more than
--tolerance, else 1.
"""

import argparse
import json
import pathlib
import shutil
import statistics
import struct
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# Scene files, of data/scenes or of the data, with the flags to run them with.
DATA_SCENES = {
    "lhdl_flexion": ("lhdl_hip_motion.json", []),
    "lhdl_adduction": ("lhdl_hip_motion.json", ["hip_adduction.mot"]),
    "lhdl_rotation": ("lhdl_hip_motion.json", ["hip_rotation.mot"]),
    "bodyparts3d_hip": ("bodyparts3d_hip.json", []),
    "bodyparts3d_hip_original": ("bodyparts3d_hip_original.json", []),
    "bodyparts3d_hamstrings": ("bodyparts3d_hamstrings_leg.json", []),
    "bodyparts3d_hamstrings_original": (
        "bodyparts3d_hamstrings_leg_original.json",
        [],
    ),
    "bodyparts3d_gluteals": ("bodyparts3d_gluteals.json", []),
    "bodyparts3d_thigh": ("bodyparts3d_thigh.json", []),
    "bodyparts3d_shank": ("bodyparts3d_shank/scene_uniform.json", []),
    "bodyparts3d_shoulder": ("bodyparts3d_shoulder/scene_uniform.json", []),
    "lhdl_paper": ("lhdl_hip.json", ["--contact=paper"]),
    "lhdl_none": ("lhdl_hip.json", ["--contact=none"]),
    "lhdl_reference": ("lhdl_hip.json", ["--solver=reference"]),
}
PHANTOM_SCENES = [
    "hip",
    "stress_attachment",
    "stress_edge",
    "stress_sweep",
    "stress_sheet",
    "stress_plate",
    "stress_resolution",
]
# Keys of report.json that tell builds and machines apart, and ends of those that
# are times.
OF_THE_BUILD = {"code", "machine", "command", "options", "inputs_hash"}
TIMES = ("_ms", "_ms_per_frame_median")
PLY_TYPES = {"double": "d", "float": "f", "int": "i", "uchar": "B"}


def scenes(data_root, work):
    """Returns (name, flags) of every scene; phantom scenes are written first."""
    found = []
    if data_root:
        for name, (scene, more) in DATA_SCENES.items():
            folder = data_root if "/" in scene else ROOT / "data/scenes"
            flags = [f"--scene={folder / scene}"]
            flags.append(f"--data_root={data_root}")
            for flag in more:
                if flag.endswith(".mot"):
                    flag = f"--motion={data_root / 'lhdl_hip/motions' / flag}"
                flags.append(flag)
            found.append((name, flags))
    for name in PHANTOM_SCENES:
        file = ROOT / "data/phantom/motion.json"
        if name != "hip":
            file = work / "scenes" / name / "scene.json"
        found.append((name, [f"--scene={file}"]))
    return found


def write_phantom_scenes(programs, work):
    for name in PHANTOM_SCENES:
        if name == "hip":
            continue
        out = work / "scenes" / name
        command = [programs / "musclewarp-phantom", f"--scene={name}"]
        subprocess.run(
            [*command, f"--out={out}"], check=True, stdout=subprocess.DEVNULL
        )


def run(programs, flags, out):
    """Deforms a scene; returns its report."""
    command = [programs / "musclewarp-deform", *flags, f"--out={out}"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"compare_builds: {command} failed:\n{done.stderr}")
    return json.loads((out / "report.json").read_text())


def ply_points(path):
    """Returns the coordinates of the vertices of a PLY file, one after another."""
    data = path.read_bytes()
    header, _, body = data.partition(b"end_header\n")
    if b"binary_little_endian" not in header:
        values = body.split()
        count = int(header.split(b"element vertex ")[1].split()[0])
        return [float(value) for value in values[: 3 * count]]
    count, kinds = 0, []
    for line in header.decode().splitlines():
        words = line.split()
        if words[:2] == ["element", "vertex"]:
            count = int(words[2])
        elif words[0] == "element":
            break
        elif words[0] == "property":
            kinds.append(PLY_TYPES[words[1]])
    points = []
    for vertex in struct.iter_unpack(
        "<" + "".join(kinds), body[: count * struct.calcsize("<" + "".join(kinds))]
    ):
        points.extend(vertex[:3])
    return points


def difference(before, after):
    """Returns (files, files that differ, largest difference in mm)."""
    files = differ = 0
    largest = 0.0
    for file in sorted(before.glob("frame_*/*.ply")):
        files += 1
        other = after / file.relative_to(before)
        if other.exists() and other.read_bytes() == file.read_bytes():
            continue
        differ += 1
        if not other.exists():
            largest = float("inf")
            continue
        a, b = ply_points(file), ply_points(other)
        if len(a) != len(b):
            largest = float("inf")
        else:
            largest = max(largest, max(abs(x - y) for x, y in zip(a, b)))
    return files, differ, largest


def without_times(value):
    """Returns what a report says but for times, machine and build, with the order
    of its keys."""
    if isinstance(value, list):
        return [without_times(item) for item in value]
    if not isinstance(value, dict):
        return value
    return [[key, without_times(item)] for key, item in value.items()
            if key not in OF_THE_BUILD and not key.endswith(TIMES)]


def other_differences(before, after):
    """Returns what differs beside meshes: names of files, and "report.json"."""
    differ = []
    for pattern in ("frame_*/*", "rest/*", "*.sto", "*.pvd", "attachments.json"):
        for file in sorted(before.glob(pattern)):
            other = after / file.relative_to(before)
            if file.is_file() and file.suffix != ".ply" and not (
                    other.exists() and other.read_bytes() == file.read_bytes()):
                differ.append(str(file.relative_to(before)))
    reports = [json.loads((out / "report.json").read_text())
               for out in (before, after)]
    if without_times(reports[0]) != without_times(reports[1]):
        differ.append("report.json")
    return differ


def times(report):
    frames = [f["solve_ms"] + f["certify_ms"] for f in report["frames"]]
    prepare = report["prepare"]
    whole = prepare["wall_ms"] + prepare.get("contact_ms", 0)
    return statistics.median(frames), whole


def usable(report):
    return sum(frame["usable"] for frame in report["frames"])


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--before", required=True, type=pathlib.Path)
    parser.add_argument("--after", required=True, type=pathlib.Path)
    parser.add_argument("--data_root", type=pathlib.Path)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--only", default="", help="names of scenes, with commas")
    parser.add_argument("--tolerance", type=float, default=0, help="mm")
    parser.add_argument(
        "--keep_before",
        action="store_true",
        help="take the results of --before that are in --out already",
    )
    options = parser.parse_args()
    write_phantom_scenes(options.after, options.out)
    only = [name for name in options.only.split(",") if name]
    all_scenes = scenes(options.data_root, options.out)
    unknown = set(only) - {name for name, _ in all_scenes}
    if unknown:
        parser.error(f"--only: no scene {', '.join(sorted(unknown))}")
    worst, is_same = 0.0, True
    print(
        "| scene | usable before, after | files | differ | by mm | other files "
        "| frame ms before, after | preparation ms before, after |\n"
        "|---|---|---|---|---|---|---|---|"
    )
    for name, flags in all_scenes:
        if only and name not in only:
            continue
        reports = []
        for build in ("before", "after"):
            out = options.out / build / name
            report = out / "report.json"
            if build == "before" and options.keep_before and report.exists():
                reports.append(json.loads(report.read_text()))
                continue
            shutil.rmtree(out, ignore_errors=True)
            reports.append(run(getattr(options, build), flags, out))
        files, differ, largest = difference(
            options.out / "before" / name, options.out / "after" / name
        )
        others = other_differences(
            options.out / "before" / name, options.out / "after" / name
        )
        worst = max(worst, largest)
        is_same = is_same and not others
        by = "identical" if differ == 0 else f"{largest:.1e}"
        (frame_a, prepare_a), (frame_b, prepare_b) = map(times, reports)
        print(
            f"| {name} | {usable(reports[0])}, {usable(reports[1])} of "
            f"{len(reports[0]['frames'])} | {files} | {differ} | {by} "
            f"| {', '.join(others) or 'identical'} "
            f"| {frame_a:.0f}, {frame_b:.0f} | {prepare_a:.0f}, {prepare_b:.0f} |",
            flush=True,
        )
    return 0 if worst <= options.tolerance and (
        is_same or options.tolerance > 0) else 1


if __name__ == "__main__":
    sys.exit(main())
