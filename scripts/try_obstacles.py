#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Has every kind of file written where it cannot be: to a disk that is full after
a part of it, to one that is read-only, to a folder that is removed meanwhile, and
to one to which a second program writes the same. Each time the program has to
say what is wrong and where, with exit code 1 or 2, or everything is there; and a
file that has its name has to be whole.

  scripts/try_obstacles.py --build=build/release --out=DIR [--kind=TEXT]

Runs in a mount namespace of its own (unshare), so that no rights are needed.

Exit code: 0 if all of that holds, else 1.
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

from run_contents import contents, difference

UNSHARED = "MUSCLEWARP_TRY_OBSTACLES"
SHARES_OF_DISK = [0, 0.3, 0.7, 0.97]  # of what the files take


def kinds(made):
    """Returns commands by what they write; {out} stands for the folder."""
    run = made / "run"
    bones = [run / f"rest/{name}.ply" for name in ("pelvis", "femur_r")]
    muscles = sorted(path for path in (run / "rest").glob("*.ply")
                     if path not in bones)
    deform = ["deform", "--demo", "--frames=0:2", "--out={out}"]
    export = ["export", f"--in={run}"]
    all_kinds = {
        "frames as ply, page, tables": [*deform, "--html"],
        "frames as obj and vtp": [*deform, "--format=obj,vtp"],
        "recorded steps": [*deform, "--record_steps"],
        "cache": [*deform, "--cache={out}/cache"],
        "page": ["report", f"--in={run}", "--out={out}/report.html"],
        "picture": ["render", f"--in={run}", "--out={out}/run.png"],
        "figures of a check": ["check", "--json={out}/check.json", *bones],
        "separation": ["separate", "--out={out}", "--json",
                       f"--bone={bones[0]}", *muscles],
        "scene": ["phantom", "--out={out}"],
        "comparison": ["compare", f"--scene={made}/scene/scene.json",
                       "--frames=0", "--configurations=reference",
                       "--out={out}"],
        "crossings": ["export", *bones, *muscles, "--format=crossings",
                      "--out={out}"],
    }
    for form, name in (("csv", "run.csv"), ("glb", "run.glb"), ("pc2", ""),
                       ("feb", ""), ("inp", ""), ("msh", ""), ("vtu", "")):
        all_kinds[f"export {form}"] = [*export, f"--format={form}", "--frames=0",
                                       f"--out={{out}}/{name}".rstrip("/")]
    all_kinds["export osim"] = ["export", f"--in={made}/motion", "--format=osim",
                                "--out={out}/model.osim"]
    return all_kinds


class Writer:
    """Calls programs that write to a folder."""

    def __init__(self, build, words):
        self.build, self.words = build, words

    def start(self, out):
        command = [self.build / f"tools/musclewarp-{self.words[0]}"]
        command += [str(word).replace("{out}", str(out))
                    for word in self.words[1:]]
        return subprocess.Popen([str(word) for word in command],
                                stdout=subprocess.DEVNULL,
                                stderr=subprocess.PIPE, text=True)

    def run(self, out):
        """Returns the exit code and what was said."""
        return end(self.start(out))


def end(process):
    said = process.communicate()[1]
    return process.returncode, said.strip()


def mount(folder, size=None, read_only=False):
    folder.mkdir(parents=True, exist_ok=True)
    if read_only:
        words = ["-t", "tmpfs", "-o", "ro", "tmpfs"]
    else:
        words = ["-t", "tmpfs", "-o", f"size={max(size, 4096)}", "tmpfs"]
    subprocess.run(["mount", *words, folder], check=True)


def unmount(folder):
    subprocess.run(["umount", "--lazy", folder], check=True)


def size_of(folder):
    """The bytes that the files of a folder take, in pages of 4 KiB."""
    return sum(-(-path.stat().st_size // 4096) * 4096
               for path in folder.rglob("*") if path.is_file())


def half_written(expected, folder):
    """Returns what a folder has that is neither whole nor marked as not done, or
    "". A report of fewer frames is whole if it can be read."""
    wrong = []
    for name, digest in contents_of_damaged(folder).items():
        is_marked = any(part.startswith(".") for part in name.split("/"))
        if is_marked or expected.get(name) == digest:
            continue
        if pathlib.Path(name).suffix == ".json" and digest != "no JSON":
            continue
        if name.endswith((".sto", ".csv", ".html")) and name in expected:
            continue  # of the frames that are there
        wrong.append(name)
    return f"half-written: {', '.join(wrong[:3])}" if wrong else ""


def contents_of_damaged(folder):
    try:
        return contents(folder)
    except json.JSONDecodeError:
        return {"report.json": "no JSON"}


def judge(code, said, place, expected, folder):
    """Returns what is wrong with the end of a program, or ""."""
    if code not in (0, 1, 2):
        return f"exit code {code}: {said[-300:]}"
    if code == 0:
        return difference(expected, contents_of_damaged(folder))
    if str(place) not in said:
        return f"exit code {code} without the place: {said[-300:]}"
    return half_written(expected, folder) if folder.exists() else ""


def try_full_disk(writer, share, expected, size, place):
    mount(place, size=int(share * size) // 4096 * 4096)
    out = place / "out"
    try:
        code, said = writer.run(out)
        return judge(code, said, place, expected, out)
    finally:
        unmount(place)


def try_read_only(writer, expected, place):
    mount(place, read_only=True)
    try:
        code, said = writer.run(place / "out")
        return ("exit code 0 on a read-only disk" if code == 0 else
                judge(code, said, place, expected, place / "out"))
    finally:
        unmount(place)


def try_removed(writer, expected, place):
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir(parents=True)
    out = place / "out"
    process = writer.start(out)
    while process.poll() is None and not out.exists():
        time.sleep(0.002)
    shutil.rmtree(out, ignore_errors=True)
    code, said = end(process)
    return judge(code, said, place, expected, out)


def try_two(writer, expected, place):
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir(parents=True)
    out = place / "out"
    ends = [end(process) for process in [writer.start(out), writer.start(out)]]
    codes = sorted(code for code, _ in ends)
    if codes[0] != 0 or codes[1] not in (0, 1, 2):
        return f"exit codes {codes}: {[said[-200:] for _, said in ends]}"
    return difference(expected, contents_of_damaged(out))


def try_kind(name, writer, options):
    """Tries all obstacles; returns how many went wrong."""
    whole = options.out / "whole"
    shutil.rmtree(whole, ignore_errors=True)
    code, said = writer.run(whole)
    if code != 0:
        print(f"{name}: exit code {code} without an obstacle: {said[-300:]}")
        return 1
    expected, size = contents(whole), size_of(whole)
    place = options.out / "place"
    tried = [(f"disk full after {share:.0%}",
              lambda share=share: try_full_disk(writer, share, expected, size,
                                                place))
             for share in SHARES_OF_DISK]
    tried += [("read-only", lambda: try_read_only(writer, expected, place)),
              ("removed", lambda: try_removed(writer, expected, place)),
              ("two at once", lambda: try_two(writer, expected, place))]
    wrong = [f"  {obstacle}: {found}" for obstacle, attempt in tried
             if (found := attempt())]
    print(f"{name}: {len(expected)} files, {len(tried) - len(wrong)} of "
          f"{len(tried)} as they should", *wrong, sep="\n", flush=True)
    return len(wrong)


def prepare(options, made):
    """Makes the runs that other commands read."""
    made.mkdir(parents=True, exist_ok=True)
    for words in (["deform", "--demo", "--frames=0:2", "--out={out}/run"],
                  ["phantom", "--out={out}/scene"],
                  ["deform", "--scene={out}/scene/motion.json",
                   "--out={out}/motion", "--contact=none"]):
        code, said = Writer(options.build, words).run(made)
        if code not in (0, 1):
            sys.exit(f"try_obstacles: {said}")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("--kind", default="", help="only kinds with this text")
    options = parser.parse_args()
    if UNSHARED not in os.environ:
        os.environ.update({UNSHARED: "1", "OMP_WAIT_POLICY": "passive"})
        os.execvp("unshare", ["unshare", "--map-root-user", "--mount",
                              sys.executable, *sys.argv])
    options.out = options.out.resolve()
    made = options.out / "made"
    prepare(options, made)
    wrong = sum(try_kind(name, Writer(options.build, words), options)
                for name, words in kinds(made).items() if options.kind in name)
    print("all as they should" if wrong == 0 else f"{wrong} went wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
