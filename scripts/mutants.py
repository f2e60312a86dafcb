#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Changes single places of the sources and runs the tests, to find out what the
tests do not notice.

  scripts/mutants.py [--count=N] [--seed=N] [--list] ROOM...

ROOM is a folder of src/musclewarp, or a source in it (motion/step_length.cc).
From the sources of the rooms N places are drawn, as many of each room as its
share of all places, and changed one at a time: a comparison or an arithmetic
operator becomes another one, a constant is doubled or halved, min becomes max, a
condition becomes true or false, a statement is dropped. For each, the tests of
the room (tests/<room>) are built and run. What they pass survives, and needs a
test or a reason why the change means nothing.

Everything happens in a copy of the last commit, in build/mutants, which is kept
for the next run; the first run has to build it. Changes that do not compile do
not count; others are drawn for them. A run of 60 takes an hour and a half on
two cores. --list prints the changes and runs nothing.

Exit code: 0 if at least --least of the changes (0.85) are noticed, else 1.
"""

import argparse
import dataclasses
import pathlib
import random
import re
import sys

from commit_copy import (COPY, builds, changed, check_out, configure_and_build,
                         run)

SOURCES = pathlib.Path("src/musclewarp")

# Tests that take this many times as long as without a change do not end.
PATIENCE = 10
SHORTEST_PATIENCE = 60  # s

OPERATORS = {
    " < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ",
    " == ": " != ", " != ": " == ",
    " + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ",
    " += ": " -= ", " -= ": " += ",
    "std::min(": "std::max(", "std::max(": "std::min(",
}
CONSTANT = re.compile(r"(?<![\w.\[<\"'])(\d+\.\d*(?:e-?\d+)?|\de-?\d+|[1-9]\d*)"
                      r"(?![\w.>\"'])")
CONDITION = re.compile(r"\b(if|while) \((.+)\)( \{| return.*;| continue;"
                       r"| break;)?$")
# A call or an assignment, but no declaration.
STATEMENT = re.compile(r"^\s*(?=\S)(?!return|throw|delete)"
                       r"\*?[\w:.\[\]()>-]+(\(.*\)| [+*/-]?= .*);$")
# What only says something, or guards what callers promise.
SKIPPED = re.compile(r"^\s*(//|#|static_assert|CHECK|DCHECK|LOG|VLOG|<<|\"|"
                     r"namespace|using|template|public:|private:)|InputError|"
                     r"InvalidOption|IsAtLeast|IsAbove|IsWithin|operator|"
                     r"ScopedStage|reserve\(")


@dataclasses.dataclass(frozen=True)
class Mutant:
    """A line of a source, and what takes its place."""

    file: str  # below src/musclewarp
    line: int  # from 1
    kind: str
    before: str
    after: str

    @property
    def room(self):
        return self.file.split("/")[0]

    def __str__(self):
        return (f"{self.file}:{self.line} ({self.kind})\n"
                f"    {self.before.strip()}\n    {self.after.strip()}")


def changes_of_line(text):
    """Yields (kind, changed line) for every change of a line of code."""
    code = text.split(" // ")[0].rstrip("\n")
    rest = text[len(code):]
    if '"' in code:
        return
    for old, new in OPERATORS.items():
        for match in re.finditer(re.escape(old), code):
            if old == " * " and code[match.end():match.end() + 1] in ",)":
                continue  # a pointer
            yield ("operator",
                   code[:match.start()] + new + code[match.end():] + rest)
    for match in CONSTANT.finditer(code):
        for factor in (2, 0.5):
            value = match.group(1)
            is_whole = re.fullmatch(r"\d+", value) is not None
            if is_whole and factor == 0.5 and int(value) % 2:
                continue
            changed = (str(int(int(value) * factor)) if is_whole
                       else f"({value} * {factor})")
            yield ("constant",
                   code[:match.start()] + changed + code[match.end():] + rest)
    condition = CONDITION.search(code)
    if condition and condition.group(2).count("(") == (
            condition.group(2).count(")")):
        for value in ("true", "false"):
            if condition.group(1) == "while" and value == "true":
                continue
            yield ("condition", code[:condition.start(2)] + value +
                   code[condition.end(2):] + rest)
    if STATEMENT.match(code) and code.count("(") == code.count(")"):
        yield "dropped", re.match(r"\s*", code).group() + ";" + rest


def mutants_of(room):
    path = COPY / SOURCES / room
    files = [path] if path.is_file() else sorted(path.glob("*.cc"))
    if not files:
        sys.exit(f"mutants: {SOURCES / room} has no sources")
    mutants = []
    for file in files:
        name = str(file.relative_to(COPY / SOURCES))
        lines = file.read_text(encoding="utf-8").split("\n")
        for number, text in enumerate(lines, 1):
            if SKIPPED.search(text):
                continue
            # The end of a statement that began on a line before is not one.
            begun = lines[number - 2].rstrip() if number > 1 else ""
            is_whole = begun == "" or begun.endswith((";", "{", "}", ":"))
            for kind, changed in changes_of_line(text):
                if kind == "dropped" and not is_whole:
                    continue
                mutants.append(Mutant(name, number, kind, text, changed))
    return mutants


def draw(mutants, generator):
    """Returns a change of each place and kind, in an order by chance."""
    by_place = {}
    for mutant in mutants:
        by_place.setdefault((mutant.file, mutant.line, mutant.kind),
                            []).append(mutant)
    places = sorted(by_place)
    generator.shuffle(places)
    return [generator.choice(by_place[place]) for place in places]


def prepare(rooms):
    """Makes the copy and builds the tests; returns how long those take."""
    check_out()
    configure_and_build("release", [f"{room}_test" for room in rooms])
    times = {}
    for room in rooms:
        passes, times[room] = run([test_of(room), "--gtest_brief=1"])
        if not passes:
            sys.exit(f"mutants: the tests of {room} fail without a change")
    return times


def test_of(room):
    return COPY / f"build/release/tests/{room}/{room}_test"


def is_noticed(mutant, patience):
    """Returns whether the tests notice a change; None if it does not compile."""
    def change(text):
        lines = text.split("\n")
        lines[mutant.line - 1] = mutant.after
        return "\n".join(lines)

    with changed(SOURCES / mutant.file, change):
        if not builds([f"{mutant.room}_test"]):
            return None
        passes, _ = run([test_of(mutant.room), "--gtest_brief=1",
                         "--gtest_fail_fast"], patience)
        return not passes


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("rooms", nargs="+", metavar="ROOM")
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--least", type=float, default=0.85)
    parser.add_argument("--list", action="store_true")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    names = sorted({room.split("/")[0] for room in arguments.rooms})
    times = {} if arguments.list and COPY.exists() else prepare(names)
    generator = random.Random(arguments.seed)
    drawn = draw([mutant for room in arguments.rooms
                  for mutant in mutants_of(room)], generator)
    noticed, survivors = 0, []
    for mutant in drawn:
        if noticed + len(survivors) == arguments.count:
            break
        if arguments.list:
            survivors.append(mutant)
            print(mutant)
            continue
        patience = max(SHORTEST_PATIENCE, PATIENCE * times[mutant.room])
        result = is_noticed(mutant, patience)
        if result is None:
            continue
        noticed += result
        if not result:
            survivors.append(mutant)
        print("noticed " if result else "SURVIVES", mutant, flush=True)
    if arguments.list:
        return 0
    count = noticed + len(survivors)
    print(f"{noticed} of {count} changes are noticed; these are not:")
    for mutant in survivors:
        print(mutant)
    return 0 if noticed >= arguments.least * count else 1


if __name__ == "__main__":
    sys.exit(main())
