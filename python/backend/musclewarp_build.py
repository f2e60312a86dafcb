# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Builds wheels and source packages of musclewarp with CMake (PEP 517).

    pip install .
    python3 -m build --wheel --no-isolation

Needs only the standard library, so that nothing is downloaded for a build. A
wheel holds the package and the programs, linked against the libraries of this
system; portable_wheel.py beside this makes one that carries them. It is built
where demo.sh and test.sh build, in build/release, so that what is compiled
there is only brought up to date. MUSCLEWARP_BUILD_DIR names another folder.
"""
import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import time
import tomllib
import zipfile

from build_progress import run_with_progress

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

# The sources are under Apache-2.0. What is built has parts of CGAL in it that
# are not, and is under their licence as a whole (README.md, "Licences").
LICENCE_OF_SOURCES = "Apache-2.0"
LICENCE_OF_WHEELS = "GPL-3.0-or-later"
_CLASSIFIERS = {
    LICENCE_OF_SOURCES:
        "License :: OSI Approved :: Apache Software License",
    LICENCE_OF_WHEELS:
        "License :: OSI Approved :: GNU General Public License v3 or later "
        "(GPLv3+)",
}
_TEXT_OF_GPL = pathlib.Path("/usr/share/common-licenses/GPL-3")
_ABOUT_LICENCES = """\
The sources of musclewarp are under Apache-2.0 (LICENSE). This wheel holds
programs and a module that contain parts of CGAL under GPL-3.0-or-later (alpha
wrap, repair of self-intersections, isotropic remeshing); the wheel as a whole
is therefore under GPL-3.0-or-later. Pages of runs contain three.js (MIT),
Observable Plot and d3 (ISC); their licences are at the foot of each page.
"""


def _project():
    return tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]


def _version():
    text = (ROOT / "CMakeLists.txt").read_text()
    return re.search(r"project\(musclewarp VERSION ([0-9.]+)", text).group(1)


def _metadata(licence):
    project = _project()
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {project['name']}",
        f"Version: {_version()}",
        f"Summary: {project['description']}",
        f"Keywords: {','.join(project['keywords'])}",
        f"License: {licence}",
        f"Requires-Python: {project['requires-python']}",
    ]
    classifiers = project["classifiers"] + [_CLASSIFIERS[licence]]
    lines += [f"Classifier: {name}" for name in sorted(classifiers)]
    lines += [f"Requires-Dist: {name}" for name in project["dependencies"]]
    for extra, names in project["optional-dependencies"].items():
        lines.append(f"Provides-Extra: {extra}")
        lines += [f'Requires-Dist: {n} ; extra == "{extra}"' for n in names]
    lines += ["Description-Content-Type: text/markdown", ""]
    return "\n".join(lines) + "\n" + (ROOT / project["readme"]).read_text()


def _platform():
    return re.sub(r"[-.]", "_", sysconfig.get_platform())


def _tag(platform):
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{platform}"


def _dist_info():
    return f"musclewarp-{_version()}.dist-info"


def _write_dist_info(folder, platform):
    info = folder / _dist_info()
    (info / "licenses").mkdir(parents=True, exist_ok=True)
    (info / "METADATA").write_text(_metadata(LICENCE_OF_WHEELS))
    (info / "WHEEL").write_text("Wheel-Version: 1.0\n"
                                "Generator: musclewarp_build\n"
                                "Root-Is-Purelib: false\n"
                                f"Tag: {_tag(platform)}\n")
    (info / "licenses" / "README").write_text(_ABOUT_LICENCES)
    shutil.copy(ROOT / "LICENSE", info / "licenses")
    if _TEXT_OF_GPL.exists():
        shutil.copy(_TEXT_OF_GPL, info / "licenses")


def _run(*command):
    command = [str(word) for word in command]
    print("musclewarp:", *command, flush=True)
    run_with_progress(command, cwd=ROOT)


def _cached(build):
    """What CMake knows of a build folder; nothing before it is configured."""
    cache = build / "CMakeCache.txt"
    lines = cache.read_text().splitlines() if cache.exists() else []
    entries = (re.match(r"(\w+):\w+=(.*)", line) for line in lines)
    return {entry[1]: entry[2] for entry in entries if entry}


def _kind_of(python):
    """What a module is compiled for; two Pythons of one kind can share it."""
    asked = "import sysconfig as s; print(s.get_config_vars('SOABI', 'INCLUDEPY'))"
    try:
        return subprocess.run([python, "-c", asked], check=True, text=True,
                              stdout=subprocess.PIPE).stdout
    except (OSError, subprocess.CalledProcessError):
        return ""


def _configure(build):
    """Configures a build folder, unless it can make the module as it is."""
    cached = _cached(build)
    wanted = []
    if not cached:
        wanted = ["-DCMAKE_BUILD_TYPE=Release", "-DMUSCLEWARP_BUILD_TESTS=OFF"]
        if shutil.which("ninja"):
            wanted += ["-G", "Ninja"]
    # What demo.sh has configured makes no module.
    if cached.get("MUSCLEWARP_WITH_PYTHON") not in ("ON", "TRUE", "1"):
        wanted.append("-DMUSCLEWARP_WITH_PYTHON=ON")
    # The Python of a virtual environment, which will not last, is of the kind
    # of the one that it was made with.
    if _kind_of(cached.get("Python_EXECUTABLE", "")) != _kind_of(sys.executable):
        wanted.append(f"-DPython_EXECUTABLE={sys.executable}")
    if wanted:
        _run("cmake", "-S", ROOT, "-B", build, *wanted)


def _build_folder():
    named = os.environ.get("MUSCLEWARP_BUILD_DIR")
    if named:
        return ROOT / named
    # demo.sh and test.sh, which build in the former, build with Ninja.
    with_ninja = _cached(ROOT / "build/release") or shutil.which("ninja")
    return ROOT / ("build/release" if with_ninja else "build/wheel")


def _build(build):
    """Builds the module and the programs."""
    _configure(build)
    _run("cmake", "--build", build, "--parallel", os.cpu_count() or 1,
         "--target", "musclewarp_python", "musclewarp_programs")


def _install(build, stage):
    """Puts the module and the programs of a build below `stage`."""
    for component in ("python", "programs"):
        _run("cmake", "--install", build, "--strip", "--prefix", stage,
             "--component", component)


def _collect(stage, folder, programs):
    """Lays out what was installed as a wheel has it."""
    module, = stage.glob("**/musclewarp/__init__.py")
    shutil.copytree(module.parent, folder / "musclewarp")
    programs = folder / programs
    programs.mkdir(parents=True)
    for program in sorted((stage / "bin").glob("musclewarp-*")):
        shutil.copy(program, programs)


def _entry(name, executable=False):
    """The entry of a file in a wheel; the same for the same contents."""
    epoch = int(os.environ.get("SOURCE_DATE_EPOCH", 315532800))  # 1980
    entry = zipfile.ZipInfo(name, time.gmtime(max(epoch, 315532800))[:6])
    entry.external_attr = (0o100755 if executable else 0o100644) << 16
    entry.compress_type = zipfile.ZIP_DEFLATED
    return entry


def _zip(folder, wheel):
    record = []
    with zipfile.ZipFile(wheel, "w") as archive:
        for path in sorted(p for p in folder.rglob("*") if p.is_file()):
            name, contents = str(path.relative_to(folder)), path.read_bytes()
            executable = path.stat().st_mode & 0o111
            archive.writestr(_entry(name, executable), contents)
            digest = base64.urlsafe_b64encode(
                hashlib.sha256(contents).digest()).rstrip(b"=").decode()
            record.append(f"{name},sha256={digest},{len(contents)}")
        name = f"{_dist_info()}/RECORD"
        record.append(f"{name},,")
        archive.writestr(_entry(name), "\n".join(record) + "\n")


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    _write_dist_info(pathlib.Path(metadata_directory), _platform())
    return _dist_info()


def build_wheel(wheel_directory, config_settings=None,
                metadata_directory=None):
    name = f"musclewarp-{_version()}-{_tag(_platform())}.whl"
    with tempfile.TemporaryDirectory(prefix="musclewarp-") as work:
        stage, folder = pathlib.Path(work, "stage"), pathlib.Path(work, "wheel")
        build = _build_folder()
        _build(build)
        _install(build, stage)
        _collect(stage, folder, f"musclewarp-{_version()}.data/scripts")
        _write_dist_info(folder, _platform())
        _zip(folder, pathlib.Path(wheel_directory, name))
    return name


def build_sdist(sdist_directory, config_settings=None):
    """Packs the committed sources with the report page (scripts/package.sh)."""
    _run("scripts/package.sh", pathlib.Path(sdist_directory).resolve())
    name = f"musclewarp-{_version()}.tar.gz"
    _add_pkg_info(pathlib.Path(sdist_directory, name))
    return name


def _add_pkg_info(path):
    import io
    import tarfile
    with tempfile.TemporaryDirectory(prefix="musclewarp-") as work:
        packed = pathlib.Path(work, path.name)
        with tarfile.open(path) as old, tarfile.open(packed, "w:gz") as new:
            for member in old:
                file = old.extractfile(member) if member.isfile() else None
                new.addfile(member, file)
            text = _metadata(LICENCE_OF_SOURCES).encode()
            info = tarfile.TarInfo(f"musclewarp-{_version()}/PKG-INFO")
            info.size = len(text)
            new.addfile(info, io.BytesIO(text))
        shutil.move(packed, path)
