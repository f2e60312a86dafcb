# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""What programs of the copy (commit_copy.py) write on the embedded scene, without
times and hashes of the code: for scripts/check_places.py."""

import dataclasses
import json
import shutil
import struct
import subprocess

from commit_copy import COPY

TOOLS = COPY / "build/release/tools"
SCENES = COPY / "data/phantom"


@dataclasses.dataclass(frozen=True)
class Output:
    """Two of them are the same if the programs did the same."""

    exit_code: int
    files: dict
    verdicts: str  # of the frames, by the report
    said: str = dataclasses.field(compare=False)

    @property
    def is_good(self):
        return self.exit_code == 0 and bool(self.files)


@dataclasses.dataclass(frozen=True)
class Probe:
    """A program with flags, and the files of its output that count. The flags
    may name the folder {scratch}."""

    name: str
    program: str
    flags: str
    pattern: str

    def output(self, scratch):
        out = scratch / "out"
        shutil.rmtree(out, ignore_errors=True)
        flags = self.flags.format(scratch=scratch, scenes=SCENES).split()
        done = subprocess.run([TOOLS / self.program, *flags, f"--out={out}"],
                              capture_output=True, text=True, errors="replace",
                              check=False)
        files = {str(path.relative_to(out)): path.read_bytes()
                 for path in sorted(out.glob(self.pattern))}
        return Output(done.returncode, files, verdicts_in(out),
                      done.stdout + done.stderr)


def verdicts_in(out):
    report = out / "report.json"
    if not report.exists():
        return ""
    frames = json.loads(report.read_text(encoding="utf-8"))["frames"]
    return json.dumps([[frame["usable"], frame["shortcomings"]]
                       for frame in frames])


def deform(name, flags, scene="{scenes}/motion.json", frames=1):
    return Probe(name, "musclewarp-deform",
                 f"--scene={scene} --frames={frames} {flags}", "frame_*/*")


certified = deform("certified contact", "--contact=certified")
paper = deform("paper contact", "--contact=paper")
free_ceres = deform("no contact, ceres", "--contact=none")
free_reference = deform("no contact, reference",
                        "--contact=none --solver=reference")
# With so few rounds the flexion by 60 degrees leaves triangles that cross, which
# happens in no pose of the scene otherwise.
crossing_steps = deform("certified contact of one round",
                        "--contact=certified --max_rounds=1",
                        "{scenes}/scene.json", 2)
bone_as_off = deform("a bone in OFF", "--contact=none",
                     "{scratch}/off/motion.json")
elements = Probe("elements for Abaqus", "musclewarp-export",
                 "--in={scratch}/run --format=inp", "*.inp")
compared = Probe("musclewarp-compare", "musclewarp-compare",
                 "--scene={scenes}/motion.json --frames=1 "
                 "--configurations=ceres_dense_cholesky", "history.csv")


def prepare(scratch):
    """Writes what the probes read, by programs without a change."""
    shutil.copytree(SCENES, scratch / "off")
    for scene in ("motion.json", "scene.json"):
        path = scratch / "off" / scene
        text = path.read_text(encoding="utf-8")
        path.write_text(text.replace("femur_r.ply", "femur_r.off"),
                        encoding="utf-8")
    write_off(scratch / "off/femur_r.ply", scratch / "off/femur_r.off")
    subprocess.run([TOOLS / "musclewarp-deform", f"--out={scratch}/run",
                    f"--scene={SCENES}/motion.json", "--frames=1"], check=True,
                   stdout=subprocess.DEVNULL)


def write_off(ply, off):
    """Converts a binary PLY of doubles and triangles, as the scene has them."""
    header, body = ply.read_bytes().split(b"end_header\n", 1)
    words = header.split()
    points, faces = (int(words[words.index(b"element", at) + 2])
                     for at in (0, words.index(b"face") - 1))
    lines = [f"OFF\n{points} {faces} 0"]
    lines += [" ".join(map(repr, point)) for point in
              struct.iter_unpack("<3d", body[:24 * points])]
    lines += [" ".join(map(str, face)) for face in
              struct.iter_unpack("<B3i", body[24 * points:])]
    off.write_text("\n".join(lines) + "\n", encoding="ascii")
