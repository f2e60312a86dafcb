#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Makes a wheel that carries its shared libraries, of what is built.

usage: portable_wheel.py BUILD FOLDER    (scripts/wheel.sh)

The libraries lie in musclewarp.libs, beside the package. The programs lie in
the package, at a fixed place relative to them; what pip writes into bin/ starts
them (musclewarp_programs.py). The name of the wheel says for which systems it
is, which follows from the symbols that it takes from them.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import musclewarp_build as backend

LIBRARIES = "musclewarp.libs"
PROGRAMS = "musclewarp/bin"
LAUNCHER = pathlib.Path(__file__).resolve().parent / "musclewarp_programs.py"

# What is left to the system (packaging/bundle_libraries.cmake), of what pip
# expects on every system that takes a manylinux wheel (PEP 600).
LEFT_TO_SYSTEM = re.compile(
    r"(ld-linux-x86-64|libc|libm|libdl|librt|libpthread|libgcc_s|libstdc\+\+)"
    r"\.so\.\d+")
# The GLIBCXX_3.4.N that systems with at least a glibc 2.N have: Ubuntu 20.04,
# AlmaLinux 9, Ubuntu 22.04, 23.10 and 24.04.
GLIBC_OF_GLIBCXX = ((28, 31), (29, 34), (30, 35), (32, 38), (33, 39))

_ABOUT_LIBRARIES = """
musclewarp.libs holds libraries as they are in Debian, but for their names and
where they look for each other. carried/packages.txt names their packages and
versions, whose sources are on https://snapshot.debian.org; carried/ has their
licences, and those of what is compiled in.
"""


def glibc_needed(said):
    """N of the glibc 2.N that a file needs, from what `objdump -p` says of it."""
    needed = [int(n) for n in re.findall(r"\bGLIBC_2\.(\d+)", said)]
    if "GLIBC_ABI_DT_RELR" in said:
        needed.append(36)
    for n in map(int, re.findall(r"\bGLIBCXX_3\.4\.(\d+)", said)):
        found = [glibc for has, glibc in GLIBC_OF_GLIBCXX if has >= n]
        if not found:
            raise ValueError(f"GLIBCXX_3.4.{n} is in no system known here "
                             "(GLIBC_OF_GLIBCXX)")
        needed.append(found[0])
    return max(needed, default=0)


def platform_tag(folder):
    """The systems that the files below `folder` run on, as wheels name them."""
    files = [path for path in folder.rglob("*") if path.is_file() and
             path.open("rb").read(4) == b"\x7fELF"]
    carried = {path.name for path in files}
    needed = 0
    for path in files:
        said = subprocess.run(["objdump", "-p", path], check=True, text=True,
                              stdout=subprocess.PIPE).stdout
        for library in re.findall(r"NEEDED +(\S+)", said):
            if library not in carried and not LEFT_TO_SYSTEM.fullmatch(library):
                raise ValueError(f"{path.name} needs {library}, which is "
                                 "neither carried nor on every system")
        needed = max(needed, glibc_needed(said))
    machine = backend._platform().removeprefix("linux_")
    return f"manylinux_2_{needed}_{machine}"


def _write_launchers(folder):
    """Lets pip write a command for each program."""
    shutil.copy(LAUNCHER, folder)
    names = sorted(path.name for path in (folder / PROGRAMS).iterdir())
    (folder / backend._dist_info() / "entry_points.txt").write_text(
        "[console_scripts]\n" +
        "".join(f"{name} = musclewarp_programs:main\n" for name in names))


def make_wheel(build, wheel_directory):
    with tempfile.TemporaryDirectory(prefix="musclewarp-") as work:
        stage, folder = pathlib.Path(work, "stage"), pathlib.Path(work, "wheel")
        backend._install(build, stage)
        backend._collect(stage, folder, PROGRAMS)
        licences = f"{backend._dist_info()}/licenses"
        backend._run("cmake", f"-DSTAGE={folder}", f"-DLIBRARIES={LIBRARIES}",
                     f"-DLICENCES={licences}/carried", "-P",
                     backend.ROOT / "packaging/bundle_libraries.cmake")
        platform = platform_tag(folder)
        backend._write_dist_info(folder, platform)
        with (folder / licences / "README").open("a") as about:
            about.write(_ABOUT_LIBRARIES)
        _write_launchers(folder)
        name = f"musclewarp-{backend._version()}-{backend._tag(platform)}.whl"
        wheel_directory.mkdir(parents=True, exist_ok=True)
        backend._zip(folder, wheel_directory / name)
    return wheel_directory / name


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: portable_wheel.py BUILD FOLDER")
    print(make_wheel(*map(pathlib.Path, sys.argv[1:])))
