# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""The flags that musclewarp-deform has, and those of the column "flags"."""
import difflib
import re
import shlex
import subprocess

from .input_error import InputError

# Flags of musclewarp-deform that columns, options or the engine set.
TAKEN = {
    "scene": 'use the column "scene"',
    "motion": 'use the column "motion"',
    "out": "OUT is given to musclewarp-cohort",
    "resume": "it is always on",
    "demo": "give a scene",
    "flagfile": "write the flags themselves",
    "threads": "use --set-threads of Snakemake in a profile",
}
PROGRAM = "musclewarp-deform"
LONGEST_HELP_S = 60


def of_program(program):
    """{name: whether it is a switch} of the flags in --help of musclewarp-deform.
    InputError if the program is another one."""
    advice = f"name {PROGRAM} with --deform, or leave --deform out"
    try:
        done = subprocess.run([program, "--help"], stdin=subprocess.DEVNULL,
                              capture_output=True, check=False,
                              timeout=LONGEST_HELP_S)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise InputError(f'--deform: "{program}" cannot say what it is '
                         f"({error}); {advice}") from None
    said = done.stdout.decode(errors="replace")
    found = re.findall(r"^  --(\w+)(=\S+)?$", said, re.M)
    if done.returncode or not found or not re.search(
            rf"^usage: {PROGRAM}\b(?!-)", said, re.M):
        raise InputError(f'--deform: "{program}" is not {PROGRAM}: its --help does '
                         f'not say "usage: {PROGRAM}"; {advice}')
    return {name: not value for name, value in found}


def _parsed(words):
    """(as written, name, value) of flags, as gflags reads them: with one hyphen or
    two, and with hyphens or underscores in the name; "" for a switch."""
    flags, waits = [], False
    for word in words:
        found = re.fullmatch(r"(--?([A-Za-z][\w-]*))(?:=(.*))?", word, re.S)
        if found:
            flags.append((found[1], found[2].replace("-", "_"), found[3] or ""))
            waits = found[3] is None
        elif waits:
            flags[-1] = (*flags[-1][:2], word)
            waits = False
    return flags


def _strays(words, known):
    """The words that are neither flags nor values of flags."""
    strays, waits = [], False
    for word in words:
        found = re.fullmatch(r"--?([A-Za-z][\w-]*)(=.*)?", word, re.S)
        if found:
            name = found[1].replace("-", "_")
            is_switch = known is not None and (
                known.get(name, False) or name[:2] == "no" and known.get(name[2:], False))
            waits = found[2] is None and not is_switch
        elif waits:
            waits = False
        else:
            strays.append(word)
    return strays


def values(words):
    """The values of flags by their names; of a flag that is given twice the last,
    as musclewarp-deform has it."""
    return {name: value for _, name, value in _parsed(words)}


def _is_known(name, known):
    return name in known or name[:2] == "no" and known.get(name[2:], False)


def split(text, where, subject, known=None):
    """Splits the column "flags" of a subject; `where` makes a message of what is
    wrong. InputError names every flag that is not among `known`, as of_program
    returns them; None: all may be."""
    try:
        words = tuple(shlex.split(text))
    except ValueError as error:
        raise InputError(where(text, f"cannot be split into flags ({error})",
                               "close the quotation marks")) from None
    problems = [where(word, f"is not a flag of {PROGRAM}", "write flags as --gap=0.2")
                for word in _strays(words, known)]
    for written, name, _ in _parsed(words):
        plain = name if name in TAKEN else re.sub("^no", "", name)
        if plain in TAKEN:
            problems.append(where(written, "may not be among the flags",
                                  TAKEN[plain]))
        elif known is not None and not _is_known(name, known):
            near = difflib.get_close_matches(name, set(known) - set(TAKEN), 1)
            problems.append(where(
                written, f"of {subject} is not a flag of {PROGRAM}",
                f"write --{near[0]}, or another flag of {PROGRAM} --help" if near
                else f"allowed are {_allowed(known)}"))
    if problems:
        raise InputError(*problems)
    return words


def _allowed(known):
    return ", ".join(f"--{name}" for name in sorted(set(known) - set(TAKEN)))
