#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Makes a man page and a bash completion of each program from its own --help.

usage: packaging/manuals.py OUT PROGRAM...

Writes OUT/man1/<program>.1 and OUT/completions/<program>. The text of --help
(src/musclewarp/program/program.cc) is the only source, so that neither can be
out of date.
"""
import dataclasses
import pathlib
import re
import subprocess
import sys


@dataclasses.dataclass
class Flag:
    name: str
    value: str  # what is to be given, as TEXT or NUMBER; empty: a switch
    text: str

    def is_on(self):
        return self.text.endswith("[true]")


# Flags that --help leaves out: of programs that read them from files, of all.
FLAGFILE = Flag("flagfile", "FILE", "reads flags from a file, one a line")
COMMON_FLAGS = [
    Flag("help", "", "prints what the program does, and its flags"),
    Flag("version", "", "prints the version"),
]


@dataclasses.dataclass
class Help:
    name: str
    version: str
    usage: list
    paragraphs: list  # what the program does
    exit_code: str
    flags: list

    def summary(self):
        """The first sentence, as the line that apropos shows."""
        sentence = re.match(r"[^.:]*(?:\.\w[^.:]*)*", self.paragraphs[0])[0]
        sentence = re.sub(r" \([^)]*\)?$", "", sentence)
        return sentence[0].lower() + sentence[1:]


def _output(program, flag):
    return subprocess.run([program, flag], check=True, text=True,
                          stdout=subprocess.PIPE).stdout


def _flags(lines):
    flags = []
    for line in lines:
        found = re.fullmatch(r"  --([\w-]+)(?:=(\w+))?", line)
        if found:
            flags.append(Flag(found[1], found[2] or "", ""))
        else:
            flags[-1].text += line.strip()
    return flags


def read_help(program):
    """What a program says of itself; ValueError if it is not as expected."""
    name = pathlib.Path(program).name
    head, found, tail = _output(program, "--help").partition("\n\nFlags (")
    usage, blank, text = head.partition("\n\n")
    text, exits, exit_code = text.partition("Exit code: ")
    if not (found and blank and exits and usage.startswith("usage: ")):
        raise ValueError(f"{name} --help has no usage, exit code or flags")
    return Help(
        name=name,
        version=_output(program, "--version").split()[-1],
        usage=[line.strip() for line in usage[len("usage: "):].split("\n")],
        paragraphs=[" ".join(part.split())
                    for part in text.strip().split("\n\n")],
        exit_code=" ".join(exit_code.split()),
        flags=(_flags(tail.split("\n")[1:-1]) +
               [FLAGFILE] * tail.startswith("--flagfile") + COMMON_FLAGS))


def _troff(text):
    text = text.replace("\\", r"\e").replace("-", r"\-")
    return r"\&" + text if text[:1] in (".", "'") else text


def man_page(said, others):
    """The man page of a program; `others` are the programs to see also."""
    lines = [f'.TH {said.name} 1 "" "musclewarp {said.version}" '
             '"User Commands"',
             ".SH NAME", f"{said.name} \\- {_troff(said.summary())}",
             ".SH SYNOPSIS", ".nf", *map(_troff, said.usage), ".fi",
             ".SH DESCRIPTION"]
    for paragraph in said.paragraphs:
        lines += [".PP", _troff(paragraph)]
    lines += [".SH OPTIONS"]
    for flag in said.flags:
        value = f"=\\fI{flag.value}\\fR" if flag.value else ""
        lines += [".TP", f"\\fB{_troff('--' + flag.name)}\\fR{value}",
                  _troff(flag.text)]
    lines += [".PP", "In brackets: the value that holds if none is given. A "
              r"switch that is on is turned off by \fB\-\-no\fR and its name.",
              ".SH EXIT STATUS", _troff(said.exit_code), ".SH SEE ALSO",
              ", ".join(f"\\fB{_troff(name)}\\fR(1)" for name in others)]
    return "\n".join(lines) + "\n"


def completion(said):
    """The bash completion of a program: its flags, and files as their values."""
    words, texts, numbers = [], [], []
    for flag in said.flags:
        prefix = "--no" if flag.is_on() and not flag.value else "--"
        words.append(prefix + flag.name + ("=" if flag.value else ""))
        if flag.value:
            (numbers if flag.value == "NUMBER" else texts).append(
                "--" + flag.name)
    # A pattern has to have one name at least.
    cases = "".join(f"    {'|'.join(names)}) {does}return ;;\n"
                    for names, does in ((numbers, ""), (texts, "_filedir; "))
                    if names)
    function = "_" + said.name.replace("-", "_")
    return f"""\
# Completion of {said.name} {said.version}, made from its --help.
{function}() {{
  local cur prev words cword split
  _init_completion -s || return
  case $prev in
{cases}  esac
  $split && return
  if [[ $cur == -* ]]; then
    COMPREPLY=($(compgen -W "{' '.join(words)}" -- "$cur"))
    [[ ${{COMPREPLY-}} == *= ]] && compopt -o nospace
  else
    _filedir
  fi
}} && complete -F {function} {said.name}
"""


def main(out, *programs):
    out = pathlib.Path(out)
    names = sorted(pathlib.Path(program).name for program in programs)
    for folder in ("man1", "completions"):
        (out / folder).mkdir(parents=True, exist_ok=True)
    for program in programs:
        said = read_help(program)
        others = [name for name in names if name != said.name]
        (out / "man1" / f"{said.name}.1").write_text(man_page(said, others))
        (out / "completions" / said.name).write_text(completion(said))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit("usage: packaging/manuals.py OUT PROGRAM...")
    main(*sys.argv[1:])
