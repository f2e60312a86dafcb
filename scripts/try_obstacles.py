#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Has every kind of file written where it cannot be: to a disk that is full after
a part of it, to one that is read-only, to a folder in one that must not be
entered, to one that is removed meanwhile, and to one to which a second program
writes the same. Each time the program has to say what is wrong and where, with
exit code 1 or 2, or everything is there; and a file that has its name has to be
whole.

  scripts/try_obstacles.py --build=build/release --out=DIR [--kind=TEXT]

Runs in a mount namespace of its own (unshare), so that no rights are needed.

Exit code: 0 if all of that holds, else 1.
"""

import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

from run_contents import contents, difference

UNSHARED = "MUSCLEWARP_TRY_OBSTACLES"
SHARES_OF_DISK = [0, 0.3, 0.7, 0.97]  # of what the files take
SHARES_OF_TIME = [0, 0.3, 0.6, 0.95]  # after which a folder is removed

# What may be missing if the program says so and where: a run does not fail
# because its preparation cannot be kept for the next one.
OPTIONAL = {"cache": "cache/"}

WITHOUT_RIGHTS = ["setpriv", "--inh-caps=-all", "--bounding-set=-all"]

# Files of which it can be told whether they have their end.
TELL_THEIR_END = (".json", ".html", ".csv", ".sto")

# What has its input in the folder, too, which cannot be removed meanwhile.
READS_FOLDER = ["demo"]


def kinds(made):
    """Returns commands by what they write; {out} stands for the folder."""
    run = made / "run"
    bones = [run / f"rest/{name}.ply" for name in ("pelvis", "femur_r")]
    muscles = sorted(path for path in (run / "rest").glob("*.ply")
                     if path not in bones)
    anew = ["deform", f"--scene={made}/scene/motion.json", "--frames=0:2",
            "--out={out}"]
    deform = [*anew, f"--cache={made}/cache"]  # takes less time
    export = ["export", f"--in={run}"]
    all_kinds = {
        "frames as ply, page, tables": [*deform, "--html"],
        "frames as obj and vtp": [*deform, "--format=obj,vtp"],
        "recorded steps": [*deform, "--record_steps={out}/steps"],
        "cache": [*anew, "--cache={out}/cache"],
        "demo": ["deform", "--demo", "--frames=0", "--out={out}"],
        "page": ["report", f"--in={run}", "--out={out}/report.html"],
        "picture": ["render", f"--in={run}", "--out={out}/run.png"],
        "figures of a check": ["check", "--json={out}/check.json", *bones],
        "separation": ["separate", "--out={out}", "--json",
                       f"--bone={bones[0]},{bones[1]}", *muscles],
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

    def start(self, out, before=()):
        """`before`: the words of a command that calls the program."""
        command = [*before, self.build / f"tools/musclewarp-{self.words[0]}"]
        command += [str(word).replace("{out}", str(out))
                    for word in self.words[1:]]
        return subprocess.Popen([str(word) for word in command],
                                stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True)

    def run(self, out, before=()):
        """Returns the exit code and what was said."""
        return end(self.start(out, before))


def end(process):
    said = process.communicate()[0]
    return process.returncode, said.strip()


class Whole:
    """What a program writes without an obstacle. It is called twice: files that
    differ hold times, and are compared by their shape. It writes to `place`, as
    with the obstacles, because reports have relative paths."""

    def __init__(self, writer, place, folder):
        self.folder, self.files = folder, {}
        self.with_times, self.fault, self.seconds = set(), "", 0
        for _ in range(2):
            make_anew(place)
            began = time.monotonic()
            code, said = writer.run(place)
            self.seconds = time.monotonic() - began
            if code != 0:
                self.fault = f"exit code {code} without an obstacle: {said[-300:]}"
                return
            found = contents(place)
            if self.files.keys() not in (set(), found.keys()):
                self.fault = "other files when called again"
            self.with_times = {name for name, digest in self.files.items()
                               if found.get(name) != digest}
            self.files = found
        shutil.rmtree(folder, ignore_errors=True)
        place.rename(folder)

    def size(self):
        """The bytes that the files take, in pages of 4 KiB."""
        return sum(-(-path.stat().st_size // 4096) * 4096
                   for path in self.folder.rglob("*") if path.is_file())

    def lacks(self, folder, optional=""):
        """Returns what is not as it should in a folder that should have all,
        but for names that begin with `optional`, or ""."""
        found = contents(folder)
        expected = {name: digest for name, digest in self.files.items()
                    if not optional or not name.startswith(optional)
                    or name in found}
        for name in self.with_times & found.keys() & expected.keys():
            if has_shape(folder / name, self.folder / name):
                found[name] = expected[name]
        return difference(expected, {name: digest
                                     for name, digest in found.items()
                                     if not is_marked(name)})

    def half_written(self, folder):
        """Returns what a folder has that is neither whole nor marked as not
        done, or "". Tables and reports of fewer frames are whole."""
        found = contents(folder)
        wrong = [name for name, digest in found.items()
                 if not is_marked(name) and self.files.get(name) != digest
                 and not self.may_differ(name, folder)]
        return f"half-written: {', '.join(wrong[:3])}" if wrong else ""


    def may_differ(self, name, folder):
        """Returns true for a whole file that has times, or is of fewer frames."""
        is_known = name in self.with_times or (
            name in self.files and pathlib.Path(name).suffix in TELL_THEIR_END)
        return is_known and has_shape(folder / name, self.folder / name)


def is_marked(name):
    """Returns true for what a program marks as not done."""
    return any(part.startswith(".") for part in name.split("/"))


def has_shape(path, model):
    """Returns true if a file of TELL_THEIR_END has its end, and if another has
    the size of the model."""
    if path.suffix == ".json":
        try:
            return bool(json.loads(path.read_text()))
        except ValueError:
            return False
    if path.suffix == ".html":
        return path.read_text(errors="replace").rstrip().endswith("</html>")
    if path.suffix in (".csv", ".sto"):
        return is_table(path.read_text(errors="replace"))
    return path.stat().st_size == model.stat().st_size


def is_table(text):
    """Returns true if the last line has as many values as the one before."""
    rows = [re.split("[,\t]", line) for line in text.splitlines()]
    return (text.endswith("\n") and
            (len(rows) < 2 or len(rows[-1]) == len(rows[-2])))


def make_anew(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)


def mount(folder, *options):
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run(["mount", "-t", "tmpfs", "-o", ",".join(options), "tmpfs",
                    folder], check=True)


def unmount(folder):
    subprocess.run(["umount", "--lazy", folder], check=True)


class Obstacles:
    """Tries a program that writes at a place. Methods return what is wrong, or
    ""."""

    def __init__(self, writer, whole, place, optional):
        self.writer, self.whole, self.place = writer, whole, place
        self.optional = optional

    def judge(self, code, said, folder):
        if code not in (0, 1, 2):
            return f"exit code {code}: {said[-300:]}"
        is_named = str(self.place) in said
        if code == 0:
            lacks = self.whole.lacks(folder, self.optional if is_named else "")
            return f"exit code 0, but {lacks}" if lacks else ""
        if not is_named:
            return f"exit code {code} without the place: {said[-300:]}"
        return self.whole.half_written(folder) if folder.exists() else ""

    def full_disk(self, share):
        size = int(share * self.whole.size()) // 4096 * 4096
        mount(self.place, f"size={max(size, 4096)}")
        try:
            out = self.place / "out"
            out.mkdir()
            return self.judge(*self.writer.run(out), out)
        finally:
            unmount(self.place)

    def read_only(self, name):
        """Writes to a folder on a disk, or to the disk itself if the name is
        empty."""
        mount(self.place, "ro")
        try:
            code, said = self.writer.run(self.place / name)
            return ("exit code 0" if code == 0 else
                    self.judge(code, said, self.place / name))
        finally:
            unmount(self.place)

    def locked(self):
        """Writes to a folder in one that must not be entered, without the rights
        of an administrator."""
        make_anew(self.place)
        (self.place / "locked").mkdir(mode=0)
        out = self.place / "locked/out"
        code, said = self.writer.run(out, WITHOUT_RIGHTS)
        if code not in (1, 2):
            return f"exit code {code}: {said[-300:]}"
        return "" if str(self.place) in said else f"no place: {said[-300:]}"

    def removed(self, share):
        """Removes the folder after a share of the time; if that is 0, as soon as
        it has something. It is renamed, which is done at once."""
        make_anew(self.place)
        out, gone = self.place / "out", self.place / "gone"
        out.mkdir()
        process = self.writer.start(out)
        began = time.monotonic()
        while process.poll() is None and (
                time.monotonic() < began + share * self.whole.seconds
                if share else not any(out.iterdir())):
            time.sleep(0.001)
        was_done = process.poll() is not None
        out.rename(gone)
        code, said = end(process)
        if was_done or (code == 0 and not self.whole.lacks(gone)):
            return ""  # it was too late
        if code == 0 and not out.exists():
            return "exit code 0, but nothing is there"
        return self.judge(code, said, out)

    def two_at_once(self):
        make_anew(self.place)
        out = self.place / "out"
        out.mkdir()
        ends = [end(process) for process in
                [self.writer.start(out), self.writer.start(out)]]
        ends.sort()
        if ends[0][0] != 0:
            return f"both failed: {[said[-200:] for _, said in ends]}"
        return self.judge(*ends[1], out) or self.whole.lacks(out)


def try_kind(name, writer, options):
    """Tries all obstacles; returns how many went wrong."""
    whole = Whole(writer, options.out / "place/out", options.out / "whole")
    if whole.fault:
        print(f"{name}: {whole.fault}", flush=True)
        return 1
    optional = OPTIONAL.get(name, "")
    place = Obstacles(writer, whole, options.out / "place", optional)
    tried = [(f"disk full after {share:.0%}",
              lambda share=share: place.full_disk(share))
             for share in SHARES_OF_DISK]
    tried += [("read-only", lambda: place.read_only("")),
              ("read-only, without the folder", lambda: place.read_only("out")),
              ("locked", place.locked)]
    tried += [(f"removed after {share:.0%} of the time",
               lambda share=share: place.removed(share))
              for share in SHARES_OF_TIME if name not in READS_FOLDER]
    tried += [("two at once", place.two_at_once)]
    wrong = [f"  {obstacle}: {found}" for obstacle, attempt in tried
             if (found := attempt())]
    print(f"{name}: {len(whole.files)} files, {len(whole.with_times)} with times, "
          f"{len(tried) - len(wrong)} of {len(tried)} as they should", *wrong, sep="\n", flush=True)
    return len(wrong)


def prepare(options, made):
    """Makes the runs that other commands read."""
    made.mkdir(parents=True, exist_ok=True)
    scene = "--scene={out}/scene/motion.json"
    for words in (["phantom", "--out={out}/scene"],
                  ["deform", scene, "--frames=0:2", "--out={out}/run",
                   "--cache={out}/cache"],
                  ["deform", scene, "--out={out}/motion", "--contact=none"]):
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
