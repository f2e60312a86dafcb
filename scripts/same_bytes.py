#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Runs musclewarp-deform in many surroundings, in which it has to write the same
bytes: with other numbers of threads and settings of OpenMP, locales, time zones
and working directories, and with other builds.

  scripts/same_bytes.py --build=build/release [--other_build=DIR...] \\
      --out=DIR -- --scene=FILE [flags of musclewarp-deform]

Compared are all files; of reports what is a result. Without flags behind
"--" the scene is the embedded one. Muscles in another order are one of the
surroundings: their files have to be the same, and those that list the muscles
are left out of the comparison.

Exit code: 0 if all are the same, else 1.
"""

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import zoneinfo

from run_contents import contents, difference

# Name, what is added to the environment.
SURROUNDINGS = [
    ("2 threads", {"OMP_NUM_THREADS": "2"}),
    ("3 threads", {"OMP_NUM_THREADS": "3"}),
    ("16 threads", {"OMP_NUM_THREADS": "16"}),
    ("OMP_DYNAMIC", {"OMP_NUM_THREADS": "4", "OMP_DYNAMIC": "true"}),
    ("OMP_PROC_BIND", {"OMP_NUM_THREADS": "2", "OMP_PROC_BIND": "true"}),
    ("OMP_NESTED", {"OMP_NUM_THREADS": "2", "OMP_MAX_ACTIVE_LEVELS": "3"}),
    ("OMP_THREAD_LIMIT", {"OMP_NUM_THREADS": "8", "OMP_THREAD_LIMIT": "2"}),
    ("locale de_DE.UTF-8", {"LC_ALL": "de_DE.UTF-8"}),  # decimal commas
    ("locale tr_TR.UTF-8", {"LC_ALL": "tr_TR.UTF-8"}),  # I is no capital of i
    ("time zone Pacific/Apia", {"TZ": "Pacific/Apia"}),
    ("time zone America/St_Johns", {"TZ": "America/St_Johns"}),
]


def lacks_of_machine(added):
    """Returns what of the surroundings this machine does not have, or "": with
    an unknown locale or time zone a program goes on with the default."""
    locale = added.get("LC_ALL")
    if locale and subprocess.run(
            [sys.executable, "-c",
             "import locale; locale.setlocale(locale.LC_ALL, '')"],
            env={**os.environ, **added}, capture_output=True,
            check=False).returncode != 0:
        return f"no locale {locale} (localedef makes it, LOCPATH names its folder)"
    zone = added.get("TZ")
    if zone and zone not in zoneinfo.available_timezones():
        return f"no time zone {zone}"
    return ""


def deform(build, out, flags, added=None, directory=None):
    """Runs musclewarp-deform. Returns what is in its folder."""
    shutil.rmtree(out, ignore_errors=True)
    environment = {**os.environ, "OMP_NUM_THREADS": "1",
                   "OMP_WAIT_POLICY": "passive", **(added or {})}
    command = [build.resolve() / "tools/musclewarp-deform", *flags,
               f"--out={out}"]
    done = subprocess.run(command, env=environment, cwd=directory, check=False,
                          capture_output=True, text=True)
    if done.returncode not in (0, 1):
        sys.exit(f"same_bytes: exit code {done.returncode}: {done.stderr}")
    return contents(out)


def whole_paths(flags):
    """Returns flags whose values that are files or folders here are whole
    paths."""
    def whole(flag):
        name, equals, value = flag.partition("=")
        is_path = equals and pathlib.Path(value).exists()
        return f"{name}={pathlib.Path(value).resolve()}" if is_path else flag
    return [whole(flag) for flag in flags]


def with_reversed_muscles(flags, folder):
    """Writes the scene with its muscles in reverse order to a folder. Returns the
    flags for it, or None if the scene has no file."""
    values = dict(flag.partition("=")[::2] for flag in flags)
    if "--scene" not in values:
        return None
    scene = pathlib.Path(values["--scene"])
    read = json.loads(scene.read_text())
    read["muscles"].reverse()
    other = folder / "reversed.json"
    other.write_text(json.dumps(read))
    values["--scene"] = str(other)
    values.setdefault("--data_root", str(scene.parent))
    return [f"{name}={value}" if value else name
            for name, value in values.items()]


def meshes(files):
    """Returns the meshes of frames; files beside them list the muscles."""
    return {name: digest for name, digest in files.items()
            if name.startswith(("frame_", "rest/"))
            and not name.endswith(".json")}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", required=True, type=pathlib.Path)
    parser.add_argument("--other_build", action="append", default=[],
                        type=pathlib.Path, help="e.g. one without OpenMP")
    parser.add_argument("--out", required=True, type=pathlib.Path)
    parser.add_argument("flags", nargs="*", metavar="FLAG",
                        help="flags of musclewarp-deform, behind --")
    options = parser.parse_args()
    out = options.out.resolve()
    out.mkdir(parents=True, exist_ok=True)
    flags = whole_paths(options.flags or ["--demo"])
    run = out / "run"  # always the same, as pages show its name
    expected = deform(options.build, run, flags)
    failures = 0

    def compare(name, found, wanted=expected):
        nonlocal failures
        differs = difference(wanted, found)
        failures += bool(differs)
        print(f"{name}: {differs or f'{len(found)} files, the same bytes'}",
              flush=True)

    for name, added in SURROUNDINGS:
        lacks = lacks_of_machine(added)
        if lacks:
            print(f"{name}: left out: {lacks}", flush=True)
        else:
            compare(name, deform(options.build, run, flags, added))
    compare("working directory /", deform(options.build, run, flags,
                                          directory="/"))
    for build in options.other_build:
        compare(f"build {build}", deform(build, run, flags))
    reversed_flags = with_reversed_muscles(flags, out)
    if reversed_flags:
        compare("muscles in reverse order",
                meshes(deform(options.build, run, reversed_flags)),
                meshes(expected))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
