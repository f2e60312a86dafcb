#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Adds a setting of the deformer to a copy of the sources by changing two files,
and looks for it wherever settings are shown.

  scripts/check_new_setting.py

The setting is a field with its line in the list of DeformerSettings, and one
line in OptionsOf(). After a build and scripts/generated.py it has to be a flag
that changes the frames, with its help, its error and its place in the man page
and the bash completion; a keyword of Python with its docstring, its place in
the signature and its error; and a row of docs/settings.md. A field without a
line in the list must not compile. Everything happens in the copy of the last
commit that scripts/mutants.py has, too (build/mutants); the first build there
takes half an hour on two cores.

Exit code: 0 if it is everywhere, else 1.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

from commit_copy import COPY, builds, changed, check_out, configure_and_build

HEADER = "src/musclewarp/settings/deformer_settings.h"
SOURCE = "src/musclewarp/settings/deformer_settings.cc"
TEXT = "weight of a contact row of the coarse solve against a Laplacian row"
TARGETS = ["musclewarp-deform", "musclewarp_python", "describe_figures",
           "describe_settings", "describe_joint_limits"]
TOOLS = COPY / "build/release/tools"
SCENE = COPY / "data/phantom/motion.json"


def replaced(text, before, after):
    if text.count(before) != 1:
        sys.exit(f"check_new_setting: this should be there once:\n{before}")
    return text.replace(before, after)


def with_field(text):
    field = "  std::string cache ="
    return replaced(text, field, "  double coarse_weight = "
                    "CertifiedContactOptions().coarse_weight;\n" + field)


def with_line_in_list(text):
    line = '      Field(&S::cache, "cache")\n'
    return replaced(text, line, '      Field(&S::coarse_weight, '
                    f'"coarse_weight")\n          .Text("{TEXT}")\n'
                    '          .AtLeast(0),\n' + line)


def with_option(text):
    line = "  certified.step.max_rounds = settings.max_rounds;\n"
    return replaced(text, line, line +
                    "  certified.coarse_weight = settings.coarse_weight;\n")


def deform(out, *flags):
    done = subprocess.run(
        [TOOLS / "musclewarp-deform", f"--scene={SCENE}", "--frames=1",
         f"--out={out}", *flags], capture_output=True, text=True, check=False)
    return done.returncode, done.stderr


def points(out):
    return (out / "frame_0001/psoas_major_r.ply").read_bytes()


def flags_found(scratch):
    """Yields (place, whether the setting is there), of the program."""
    deform(scratch / "as_is")
    deform(scratch / "other", "--coarse_weight=1")
    yield "the flag", points(scratch / "as_is") != points(scratch / "other")
    code, said = deform(scratch / "bad", "--coarse_weight=-1")
    yield "its error", code == 2 and (
        "--coarse_weight: is -1; allowed: 0 or above" in said)
    said = subprocess.run([TOOLS / "musclewarp-deform", "--help"], check=True,
                          capture_output=True, text=True).stdout
    yield "--help", ("--coarse_weight=NUMBER" in said
                     and f"{TEXT} (0 or above) [0.3]" in said)
    subprocess.run([sys.executable, COPY / "packaging/manuals.py", scratch,
                    TOOLS / "musclewarp-deform"], check=True)
    manual = (scratch / "man1/musclewarp-deform.1").read_text("utf-8")
    yield "the man page", TEXT in manual
    completion = (scratch / "completions/musclewarp-deform").read_text("utf-8")
    yield "the bash completion", "coarse_weight" in completion


def keyword_found(scratch):
    """Yields (place, whether the setting is there), of Python."""
    subprocess.run([COPY / "scripts/generated.py"], check=True)
    code = f"""
import inspect
import musclewarp as mw
scene = mw.read_scene({str(SCENE)!r})
print(inspect.signature(mw.Deformer).parameters["coarse_weight"].default)
print({TEXT!r} in " ".join(mw.Deformer.__doc__.split()))
try:
    mw.Deformer(scene, coarse_weight=-1)
except mw.InputError as error:
    print(error)
weights = (0.3, 1)
frames = [mw.Deformer(scene, coarse_weight=weight).move_to(scene.poses[1])
          for weight in weights]
print((frames[0].muscles[0].points != frames[1].muscles[0].points).any())
"""
    environment = dict(os.environ, PYTHONPATH=str(COPY / "build/release/python"))
    lines = subprocess.run([sys.executable, "-c", code], env=environment,
                           cwd=scratch, check=True, capture_output=True,
                           text=True).stdout.split("\n")
    yield "the signature", lines[0] == "0.3"
    yield "the docstring", lines[1] == "True"
    yield "the error of Python", (
        lines[2] == "coarse_weight: is -1; allowed: 0 or above")
    yield "the keyword", lines[3] == "True"
    docs = (COPY / "docs/settings.md").read_text(encoding="utf-8")
    yield "docs/settings.md", (f"| `coarse_weight` |  | `0.3` | 0 or above | "
                               f"{TEXT} |") in docs


def main():
    check_out()
    configure_and_build("release", TARGETS)
    with changed(HEADER, with_field):
        places = [("no build without a line in the list",
                   not builds(["musclewarp-deform"]))]
    scratch = pathlib.Path(tempfile.mkdtemp(prefix="check_new_setting_"))
    try:
        with changed(HEADER, lambda text: with_line_in_list(with_field(text))), \
                changed(SOURCE, with_option):
            if not builds(TARGETS):
                sys.exit("check_new_setting: the setting does not compile")
            places += [*flags_found(scratch), *keyword_found(scratch)]
    finally:
        shutil.rmtree(scratch)
        check_out()
    for place, is_there in places:
        print(f"{'found ' if is_there else 'MISSING'} {place}", flush=True)
    return 0 if all(is_there for _, is_there in places) else 1


if __name__ == "__main__":
    sys.exit(main())
