# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Every program has a man page and a completion, with all of its flags."""
import re
import subprocess

import pytest

from conftest import BUILD, PROGRAMS

NAMES = sorted(path.name for path in PROGRAMS.glob("musclewarp-*")
               if path.is_file())


def said_by(name):
    return subprocess.run([PROGRAMS / name, "--help"], check=True, text=True,
                          stdout=subprocess.PIPE).stdout


@pytest.mark.parametrize("name", NAMES)
def test_every_flag_is_there(name):
    flags = re.findall(r"^  --(\w+)(=?)", said_by(name), re.M)
    assert flags
    page = (BUILD / f"manuals/man1/{name}.1").read_text(encoding="utf-8")
    shown = re.findall(r"^\.TP\n\\fB\\-\\-(\w+)\\fR", page, re.M)
    assert shown == [flag for flag, _ in flags] + ["flagfile", "help",
                                                   "version"]
    completion = (BUILD / f"manuals/completions/{name}").read_text()
    offered = re.search(r'compgen -W "(.*?)"', completion)[1].split()
    for flag, value in flags:
        assert (f"--{flag}{value}" in offered or
                not value and f"--no{flag}" in offered)


@pytest.mark.parametrize("name", NAMES)
def test_bash_reads_the_completion(name):
    # The functions of bash-completion stand here as it has them.
    script = f"""
_init_completion() {{ cur=--; prev=x; split=false; }}
. {BUILD}/manuals/completions/{name}
_{name.replace('-', '_')} 2>/dev/null
echo "${{COMPREPLY[@]}}"
complete -p {name}"""
    done = subprocess.run(["bash", "-uc", script], capture_output=True,
                          text=True, check=True)
    offered, registered = done.stdout.strip().split("\n")
    assert "--help" in offered.split() and "--version" in offered.split()
    assert registered.endswith(name)


def test_there_are_all_programs():
    assert len(NAMES) >= 8
