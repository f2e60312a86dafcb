#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Measures time and memory of musclewarp-deform on scenes at the limits: muscles of
many vertices, many muscles, many frames (docs/limits.md).

  scripts/measure_limits.py --build=build/release --out=DIR [CASE...]

Prints a line of a Markdown table for each case: what was estimated, what was held
at most, and how long it took. --list prints the names of the cases.
"""

import argparse
import json
import os
import pathlib
import shutil
import sys
import time

GIB = 2 ** 30


def cases():
    """Returns flags of musclewarp-phantom, copies of the scene side by side, and
    flags of musclewarp-deform, by name."""
    two = ["--num_muscles=2", "--seed=9"]
    found = {}
    for vertices in (1000, 10_000, 100_000, 300_000):
        for contact in ("none", "certified"):
            found[f"{vertices} vertices, {contact}"] = (
                [*two, f"--num_vertices={vertices}", "--num_poses=2"], 1,
                [f"--contact={contact}"])
    found["210 muscles, certified"] = (
        ["--num_muscles=10", "--seed=9", "--num_vertices=400", "--num_poses=2"],
        21, [])
    for contact in ("none", "certified"):
        found[f"10 000 frames, {contact}"] = (
            [*two, "--num_vertices=300", "--num_poses=10000"], 1,
            [f"--contact={contact}"])
    return found


def run(command, log):
    """Returns the exit code, the seconds and the largest memory of a program,
    bytes."""
    began = time.monotonic()
    with open(log, "w", encoding="utf-8") as file:
        child = os.posix_spawnp(
            str(command[0]), [str(word) for word in command], os.environ,
            file_actions=[(os.POSIX_SPAWN_DUP2, file.fileno(), 1),
                          (os.POSIX_SPAWN_DUP2, file.fileno(), 2)])
        _, status, usage = os.wait4(child, 0)
    return (os.waitstatus_to_exitcode(status), time.monotonic() - began,
            1024 * usage.ru_maxrss)


def renamed(scene, number):
    """Returns a scene with the names of a copy, and its files in a folder."""
    for part in scene["muscles"] + scene["bones"]:
        part["mesh"] = f"{number}/{part['mesh']}"
        part["name"] += f"_{number}"
    for bone in scene["bones"]:
        bone["body"] += f"_{number}"
    for muscle in scene["muscles"]:
        for line in muscle["lines"]:
            line["name"] += f"_{number}"
            line["bodies"] = [f"{body}_{number}" for body in line["bodies"]]
        for attachment in muscle.get("attachments", []):
            attachment["body"] += f"_{number}"
    for pose in scene["poses"]:
        pose["bodies"] = {f"{body}_{number}": matrix
                          for body, matrix in pose["bodies"].items()}
    return scene


def make_scene(options, folder, flags, copies):
    """Writes a scene, or copies of one that are a metre apart along each axis.
    Returns its file."""
    whole = None
    for number in range(copies):
        out = folder / str(number)
        code, _, _ = run([options.build / "tools/musclewarp-phantom",
                          "--scene=random", f"--out={out}", *flags,
                          f"--offset={1000 * number}"], folder / "phantom.log")
        if code != 0:
            sys.exit((folder / "phantom.log").read_text())
        scene = renamed(json.loads((out / "scene.json").read_text()), number)
        if whole is None:
            whole = scene
            continue
        whole["muscles"] += scene["muscles"]
        whole["bones"] += scene["bones"]
        for pose, more in zip(whole["poses"], scene["poses"]):
            pose["bodies"].update(more["bodies"])
    file = folder / "scene.json"
    file.write_text(json.dumps(whole))
    return file


def measure(options, name, case):
    """Returns a line of the table."""
    flags, copies, deform = case
    folder = options.out / name.replace(" ", "_").replace(",", "")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    scene = make_scene(options, folder, flags, copies)
    out = folder / "out"
    code, seconds, memory = run(
        [options.build / "tools/musclewarp-deform", f"--scene={scene}",
         f"--out={out}", *deform], folder / "deform.log")
    report = json.loads((out / "report.json").read_text())
    muscles = report["prepare"]["muscles"]
    vertices = sum(muscle["fine_vertices"] for muscle in muscles)
    bones = sum(bone["vertices"] for bone in report["prepare"]["bones"])
    usable = sum(frame["usable"] for frame in report["frames"])
    prepare = report["prepare"]
    prepared = (prepare["wall_ms"] + prepare.get("contact_ms", 0)) / 1000
    if not options.keep:
        shutil.rmtree(folder)
    return (f"| {name} | {len(muscles)} | {vertices} | {bones} | "
            f"{usable} of {len(report['frames'])} | "
            f"{prepare['memory_needed_gib']:.2f} | {memory / GIB:.2f} | "
            f"{prepared:.1f} | {seconds:.1f} | {code} |")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--keep", action="store_true", help="keep the runs")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("cases", nargs="*", metavar="CASE", help="default: all")
    options = parser.parse_args()
    known = cases()
    if options.list:
        print("\n".join(known))
        return
    for name in options.cases:
        if name not in known:
            parser.error(f'there is no case "{name}"; see --list')
    print("| case | muscles | their vertices | vertices of bones | usable | "
          "GiB expected | GiB | preparation s | whole run s | exit |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    for name in options.cases or known:
        print(measure(options, name, known[name]), flush=True)


if __name__ == "__main__":
    main()
