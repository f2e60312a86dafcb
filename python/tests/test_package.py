# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The package: how it is built, what is in it, what it loads."""
import os
import pathlib
import re
import subprocess
import sys
import zipfile

import pytest

from conftest import SOURCE


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], text=True,
                          capture_output=True, **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def environment(**changes):
    """Without this build's package, and without a network to ask."""
    result = {k: v for k, v in os.environ.items() if k != "PYTHONPATH"}
    result.update(PIP_NO_INDEX="1", PIP_DISABLE_PIP_VERSION_CHECK="1",
                  MUSCLEWARP_BUILD_DIR=os.environ["MUSCLEWARP_BUILD"],
                  **changes)
    return result


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    folder = tmp_path_factory.mktemp("wheel")
    run(sys.executable, "-m", "build", "--wheel", "--no-isolation",
        "--outdir", folder, SOURCE, env=environment())
    path, = folder.glob("*.whl")
    return path


def test_the_wheel_holds_the_package_and_the_programs(wheel):
    with zipfile.ZipFile(wheel) as archive:
        assert archive.testzip() is None
        names = set(archive.namelist())
    for file in (SOURCE / "python/musclewarp").iterdir():
        if file.is_file():
            assert f"musclewarp/{file.name}" in names
    for program in ("check", "compare", "deform", "phantom", "report",
                    "separate"):
        assert any(name.endswith(f".data/scripts/musclewarp-{program}")
                   for name in names), program


def test_the_wheel_says_its_licence(wheel):
    with zipfile.ZipFile(wheel) as archive:
        info, = {n.split("/")[0] for n in archive.namelist()
                 if ".dist-info/" in n}
        metadata = archive.read(f"{info}/METADATA").decode()
        about = archive.read(f"{info}/licenses/README").decode()
        licence = archive.read(f"{info}/licenses/LICENSE")
    # The module has parts of CGAL under the GPL in it.
    assert "\nLicense: GPL-3.0-or-later\n" in metadata
    assert "GPL-3.0-or-later" in about and "Apache-2.0" in about
    assert licence == (SOURCE / "LICENSE").read_bytes()


def test_is_installed_by_pip_without_a_network(tmp_path):
    python = tmp_path / "venv/bin/python"
    run(sys.executable, "-m", "venv", "--system-site-packages",
        "--without-pip", tmp_path / "venv")
    run(sys.executable, "-m", "pip", "--python", python, "install", SOURCE,
        env=environment())
    assert "musclewarp" in run(
        python, "-c", "import musclewarp; print(musclewarp.__file__)",
        cwd=tmp_path, env=environment())
    version = run(python, "-c",
                  "import importlib.metadata as m; print(m.version"
                  "('musclewarp'))", cwd=tmp_path, env=environment())
    said = run(tmp_path / "venv/bin/musclewarp-deform", "--version")
    assert said.startswith(f"musclewarp-deform {version.strip()} (sources ")


def test_loads_nothing_heavy():
    # numpy alone would take longer than the package: it loads with the first
    # array that is asked for.
    loaded = run(sys.executable, "-c",
                "import sys\nbefore = set(sys.modules)\nimport musclewarp\n"
                "print(*set(sys.modules) - before)").split()
    assert "musclewarp._core" in loaded
    for package in ("matplotlib", "nibabel", "numpy", "pyvista", "scipy",
                    "vtkmodules"):
        assert package not in loaded, package


def test_the_version_is_that_of_the_library():
    import musclewarp
    text = pathlib.Path(SOURCE, "CMakeLists.txt").read_text()
    assert re.search(f"VERSION {re.escape(musclewarp.__version__)} ", text)


def test_all_names_of_the_package_are_there_and_explained():
    import musclewarp
    for name in musclewarp.__all__:
        assert hasattr(musclewarp, name)
        if name != "__version__":
            assert getattr(musclewarp, name).__doc__, name
