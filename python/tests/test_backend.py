# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The backend that makes wheels: what it configures, what it says and writes."""
import pathlib
import signal
import subprocess
import sys
import zipfile

import pytest

from conftest import SOURCE

sys.path.insert(0, str(SOURCE / "python/backend"))
import build_progress  # noqa: E402
import musclewarp_build  # noqa: E402
import portable_wheel  # noqa: E402


@pytest.fixture
def configured(monkeypatch):
    """The arguments with which a folder is configured; none if it is not."""
    commands = []
    monkeypatch.setattr(musclewarp_build, "_run",
                        lambda *words: commands.append(list(map(str, words))))

    def configure(folder, cache=None):
        if cache is not None:
            (folder / "CMakeCache.txt").write_text(cache)
        musclewarp_build._configure(folder)
        return commands.pop()[1:] if commands else []
    return configure


def test_a_folder_that_makes_the_module_is_left_as_it_is(configured, tmp_path):
    assert configured(tmp_path, "// Python\nMUSCLEWARP_WITH_PYTHON:BOOL=ON\n"
                      f"Python_EXECUTABLE:FILEPATH={sys.executable}\n") == []


def test_a_folder_of_the_demo_gets_python_and_keeps_all_else(configured,
                                                             tmp_path):
    assert configured(tmp_path, "MUSCLEWARP_WITH_PYTHON:BOOL=OFF\n"
                      "MUSCLEWARP_BUILD_TESTS:BOOL=ON\n"
                      f"Python_EXECUTABLE:UNINITIALIZED={sys.executable}\n") == [
        "-S", str(SOURCE), "-B", str(tmp_path), "-DMUSCLEWARP_WITH_PYTHON=ON"]


def test_a_folder_for_another_python_gets_this_one(configured, tmp_path):
    assert configured(tmp_path, "MUSCLEWARP_WITH_PYTHON:BOOL=ON\n"
                      "Python_EXECUTABLE:FILEPATH=/gone/bin/python\n")[4:] == [
        f"-DPython_EXECUTABLE={sys.executable}"]


def test_a_virtual_environment_shares_the_module_of_its_python(configured,
                                                               tmp_path):
    subprocess.run([sys.executable, "-m", "venv", "--without-pip",
                    tmp_path / "venv"], check=True)
    assert configured(tmp_path, "MUSCLEWARP_WITH_PYTHON:BOOL=ON\n"
                      f"Python_EXECUTABLE:FILEPATH={tmp_path}/venv/bin/python\n"
                      ) == []


def test_a_new_folder_is_a_release_without_tests(configured, tmp_path):
    arguments = configured(tmp_path)
    for wanted in ("-DCMAKE_BUILD_TYPE=Release", "-DMUSCLEWARP_BUILD_TESTS=OFF",
                   "-DMUSCLEWARP_WITH_PYTHON=ON"):
        assert wanted in arguments


def test_builds_where_the_environment_says(monkeypatch):
    monkeypatch.setenv("MUSCLEWARP_BUILD_DIR", "build/other")
    assert musclewarp_build._build_folder() == SOURCE / "build/other"
    monkeypatch.setenv("MUSCLEWARP_BUILD_DIR", "/elsewhere")
    assert musclewarp_build._build_folder() == pathlib.Path("/elsewhere")
    monkeypatch.delenv("MUSCLEWARP_BUILD_DIR")
    assert musclewarp_build._build_folder().parent == SOURCE / "build"


def test_the_terminal_is_told_how_far_a_build_is(monkeypatch, tmp_path, capfd):
    said = tmp_path / "terminal"
    monkeypatch.setattr(build_progress, "_terminal", lambda: said.open("w"))
    monkeypatch.setattr(build_progress, "SECONDS_BETWEEN_LINES", 0)
    build_progress.run_with_progress(
        ["printf", "-- found\n[3/12] a.o\n[ 50%%] b.o\n"], cwd=tmp_path)
    assert [line.split(" after")[0] for line in said.read_text().split("\n")
            if "musclewarp" in line] == ["musclewarp: 25 % is compiled",
                                         "musclewarp: 50 % is compiled"]
    assert capfd.readouterr().out == "-- found\n[3/12] a.o\n[ 50%] b.o\n"
    with pytest.raises(subprocess.CalledProcessError):
        build_progress.run_with_progress(["false"], cwd=tmp_path)


def test_the_name_of_a_wheel_follows_from_the_symbols_it_needs():
    needed = portable_wheel.glibc_needed
    assert needed("libc.so.6: GLIBC_2.2.5 GLIBC_2.34") == 34
    assert needed("GLIBC_2.14\nGLIBC_ABI_DT_RELR") == 36
    # A library of g++ 12 goes with glibc 2.35, one of g++ 13.2 with 2.38.
    assert needed("GLIBC_2.34 GLIBCXX_3.4.30") == 35
    assert needed("GLIBC_2.36 GLIBCXX_3.4.30") == 36
    assert needed("GLIBCXX_3.4.31") == 38
    with pytest.raises(ValueError, match="GLIBCXX_3.4.99"):
        needed("GLIBCXX_3.4.99")


def test_the_same_contents_make_the_same_wheel(monkeypatch, tmp_path):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    info = tmp_path / "in" / musclewarp_build._dist_info()
    info.mkdir(parents=True)
    (info / "METADATA").write_text("Name: musclewarp\n")
    for name in ("a.whl", "b.whl"):
        musclewarp_build._zip(tmp_path / "in", tmp_path / name)
        with zipfile.ZipFile(tmp_path / name) as archive:
            assert {entry.date_time for entry in archive.infolist()} == {
                (2023, 11, 14, 22, 13, 20)}
    assert (tmp_path / "a.whl").read_bytes() == (tmp_path / "b.whl").read_bytes()


@pytest.fixture
def command(tmp_path):
    """Installs a script as a program of a wheel; returns how pip starts it."""
    programs = tmp_path / "musclewarp/bin"
    programs.mkdir(parents=True)
    launcher = tmp_path / portable_wheel.LAUNCHER.name
    launcher.write_bytes(portable_wheel.LAUNCHER.read_bytes())

    def install(script):
        program = programs / "musclewarp-try"
        program.write_text(f"#!/bin/bash\n{script}\n")
        program.chmod(0o755)
        started = tmp_path / "musclewarp-try"
        started.write_text("import sys\nfrom musclewarp_programs import main\n"
                           "sys.exit(main())\n")
        return [sys.executable, "-B", str(started)]
    return install


def test_a_command_has_the_arguments_and_exit_code_of_its_program(command):
    done = subprocess.run([*command('printf "<%s>" "$@"; exit 2'), "a b", ""],
                          stdout=subprocess.PIPE)
    assert (done.returncode, done.stdout) == (2, b"<a b><>")


def test_a_command_is_its_program_for_signals(command):
    with subprocess.Popen(command("echo ready; exec sleep 60"),
                          stdout=subprocess.PIPE) as process:
        assert process.stdout.readline() == b"ready\n"
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=10) == -signal.SIGINT
    # As in "musclewarp-check ... | head -1".
    with subprocess.Popen(command("while echo more; do :; done"),
                          stdout=subprocess.PIPE) as process:
        process.stdout.readline()
        process.stdout.close()
        assert process.wait(timeout=10) == -signal.SIGPIPE


def test_a_command_whose_program_is_gone_says_so(command, tmp_path):
    started = command("exit 0")
    (tmp_path / "musclewarp/bin/musclewarp-try").unlink()
    done = subprocess.run(started, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 1
    assert done.stderr.startswith("musclewarp-try: cannot start ")
