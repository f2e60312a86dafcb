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
    offered = re.search(r'compgen -W "(--.*?)"', completion)[1].split()
    for flag, value in flags:
        assert (f"--{flag}{value}" in offered or
                not value and f"--no{flag}" in offered)


@pytest.mark.parametrize("name", NAMES)
def test_examples_have_flags_of_the_program(name):
    said = said_by(name)
    examples = re.search(r"^Examples:\n((?:  .*\n)+)", said, re.M)[1]
    commands = re.findall(r"^  (\S.*)", examples, re.M)
    assert len(commands) >= 2
    flags = re.findall(r"^  --(\w+)", said, re.M)
    page = (BUILD / f"manuals/man1/{name}.1").read_text(encoding="utf-8")
    for command in commands:
        assert command.split()[0] == name
        assert set(re.findall(r"--(\w+)", command)) <= {*flags, "flagfile"}
        shown = page.split("\n.SH EXAMPLES\n")[1].replace("\\-", "-")
        assert f"\\fB{command}\\fR" in shown


@pytest.mark.parametrize("name", NAMES)
def test_short_help_is_the_start_of_help(name):
    short = subprocess.run([PROGRAMS / name, "-h"], check=True, text=True,
                           stdout=subprocess.PIPE).stdout
    said = said_by(name)
    most_used = re.findall(r"^  --(\w+)", short, re.M)
    flags = re.findall(r"^  --(\w+)", said, re.M)
    assert 0 < len(most_used) <= 6
    assert flags[:len(most_used)] == most_used  # and none of them again
    assert len(set(flags)) == len(flags)
    assert f"--help lists all {len(flags)})" in short
    assert said.startswith(short.split("\nMost used")[0])


def completed(name, flag, start):
    """What bash offers for the value of a flag that begins with `start`."""
    script = f"""
_init_completion() {{ cur='{start}'; prev={flag}; split=true; }}
_filedir() {{ COMPREPLY=(a_file); }}
. {BUILD}/manuals/completions/{name}
_{name.replace('-', '_')}
echo "${{COMPREPLY[@]}}"
"""
    return subprocess.run(["bash", "-uc", script], capture_output=True,
                          text=True, check=True).stdout.split()


def test_values_are_offered_where_words_are_known():
    contacts = ["certified", "paper", "none"]
    deform = "musclewarp-deform"
    assert completed(deform, "--contact", "") == contacts
    assert completed(deform, "--contact", "pa") == ["paper"]
    assert completed(deform, "--solver", "c") == ["ceres"]
    assert completed(deform, "--format", "ply,o") == ["ply,obj"]
    assert completed(deform, "--scene", "") == ["a_file"]
    assert completed("musclewarp-export", "--format", "g") == ["glb"]


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
