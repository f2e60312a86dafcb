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
    value: str  # what is to be given, as TEXT or ply|obj,...; empty: a switch
    text: str

    def is_on(self):
        return self.text.endswith("[true]")

    def words(self):
        """The words that its value may be; none if it may be others."""
        return self.value.removesuffix(",...").split("|") * ("|" in self.value)


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
    examples: list  # (command, what it does)
    groups: list  # (heading or "", flags)

    def flags(self):
        return [flag for _, flags in self.groups for flag in flags]

    def summary(self):
        """The first sentence, as the line that apropos shows."""
        sentence = re.match(r"[^.:]*(?:\.\w[^.:]*)*", self.paragraphs[0])[0]
        sentence = re.sub(r" \([^)]*\)?$", "", sentence)
        return sentence[0].lower() + sentence[1:]


def _output(program, flag):
    return subprocess.run([program, flag], check=True, text=True,
                          stdout=subprocess.PIPE).stdout


def _entries(lines):
    """(term, text) of indented lines: terms, and further to the right texts."""
    entries = []
    for line in lines:
        if line.startswith("   "):
            entries[-1][1] += line.strip()
        else:
            entries.append([line.strip(), ""])
    return entries


def _flags(lines):
    flags = []
    for term, text in _entries(lines):
        name, _, value = term.removeprefix("--").partition("=")
        flags.append(Flag(name, value, text))
    return flags


def _groups(lines):
    """(heading, flags) of lines with flags, some of them after headings."""
    groups = [("", [])]
    for line in filter(None, lines):
        if line.startswith(" "):
            groups[-1][1].append(line)
        else:
            groups.append((line.rstrip(":"), []))
    return [(heading, _flags(flags)) for heading, flags in groups if flags]


def read_help(program):
    """What a program says of itself; ValueError if it is not as expected."""
    name = pathlib.Path(program).name
    head, found, tail = _output(program, "--help").partition("\n\nFlags (")
    head, _, examples = head.partition("\n\nExamples:\n")
    usage, blank, text = head.partition("\n\n")
    text, exits, exit_code = text.partition("Exit code: ")
    if not (found and blank and exits and usage.startswith("usage: ")):
        raise ValueError(f"{name} --help has no usage, exit code or flags")
    common = [FLAGFILE] * tail.startswith("--flagfile") + COMMON_FLAGS
    groups = _groups(tail.split("\n")[1:])
    is_grouped = any(heading for heading, _ in groups)
    return Help(
        name=name,
        version=_output(program, "--version").split()[-1],
        usage=[line.strip() for line in usage[len("usage: "):].split("\n")],
        paragraphs=[" ".join(part.split())
                    for part in text.strip().split("\n\n")],
        exit_code=" ".join(exit_code.split()),
        examples=_entries(examples.splitlines()),
        groups=[*groups, ("Of all programs" * is_grouped, common)])


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
    for heading, flags in said.groups:
        lines += [f".SS {_troff(heading)}"] * bool(heading)
        for flag in flags:
            value = f"=\\fI{_troff(flag.value)}\\fR" if flag.value else ""
            lines += [".TP", f"\\fB{_troff('--' + flag.name)}\\fR{value}",
                      _troff(flag.text)]
    lines += [".PP", "In brackets: the value that holds if none is given. A "
              r"switch that is on is turned off by \fB\-\-no\fR and its name.",
              ".SH EXIT STATUS", _troff(said.exit_code)]
    lines += [".SH EXAMPLES"] * bool(said.examples)
    for command, what in said.examples:
        lines += [".TP", f"\\fB{_troff(command)}\\fR", _troff(what)]
    lines += [".SH SEE ALSO",
              ", ".join(f"\\fB{_troff(name)}\\fR(1)" for name in others)]
    return "\n".join(lines) + "\n"


def _values_of(flag):
    """What bash does to complete the value of a flag."""
    if flag.value == "NUMBER":
        return "return"
    if not flag.words():
        return "_filedir; return"
    words = " ".join(flag.words())
    if not flag.value.endswith(",..."):
        return f'COMPREPLY=($(compgen -W "{words}" -- "$cur")); return'
    # Of several words with commas, the last one is to be completed.
    return (f'COMPREPLY=($(compgen -P "${{cur%"${{cur##*,}}"}}" -W "{words}" '
            '-- "${cur##*,}")); return')


def completion(said):
    """The bash completion of a program: its flags, the words that their values
    may be, and files as their other values."""
    words, names = [], {}
    for flag in said.flags():
        prefix = "--no" if flag.is_on() and not flag.value else "--"
        words.append(prefix + flag.name + ("=" if flag.value else ""))
        if flag.value:
            names.setdefault(_values_of(flag), []).append("--" + flag.name)
    cases = "".join(f"    {'|'.join(flags)}) {does} ;;\n"
                    for does, flags in names.items())
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
