#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Checks that files and functions stay small, tested and explained.

usage: .ci/check_sizes.py

Fails, and names the offenders, if among the tracked C++ files
  - a source has more than 400 lines, or a header more than 300;
  - a function has more than 60 lines from its opening to its closing brace,
    but for the lists of fields of base/described.h, which are data;
  - fewer than three quarters of the sources of src, problems and tools have a
    test of the same stem: tests/**/<stem>_test.cc;
  - fewer than 35 % of the lines of the headers of src, problems and tools are
    comments. Blank lines and the two lines of the licence do not count.
"""
import collections
import os
import pathlib
import re
import subprocess
import sys

MAX_SOURCE_LINES = 400
MAX_HEADER_LINES = 300
MAX_FUNCTION_LINES = 60
LIST = " FieldsOf(Described<"
MIN_TESTED_SHARE = 0.75
MIN_COMMENT_SHARE = 0.35
CODE_FOLDERS = ("src/", "problems/", "tools/")

# What braces in the text of a file may hide in.
_NOT_CODE = re.compile(
    r"""//[^\n]*                               # comments
      | /\*.*?\*/
      | R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"   # raw strings
      | "(?:\\.|[^"\\\n])*"
      | (?<![0-9A-Za-z_])'(?:\\.|[^'\\\n])+'   # but not 10'000
      | ^[ \t]*\#(?:\\\n|[^\n])*               # preprocessor lines
    """,
    re.VERBOSE | re.DOTALL | re.MULTILINE)
# A brace after one of these encloses declarations, of which some may be
# functions.
_SCOPE = re.compile(r"^(?:template\s*<.*>\s*)?"
                    r"(?:inline\s+)?(?:namespace|struct|class|union|extern)\b",
                    re.DOTALL)


def tracked_files():
    """The paths of the C++ files that git tracks and that are there."""
    # A checkout made by another user is read all the same.
    listed = subprocess.run(
        ["git", "-c", "safe.directory=*", "ls-files", "*.h", "*.cc"],
        check=True, capture_output=True, text=True).stdout.split()
    return [path for path in listed if pathlib.Path(path).exists()]


def without_text(source):
    """The source with blanks for comments, strings and preprocessor lines."""
    return _NOT_CODE.sub(lambda found: re.sub(r"[^\n]", " ", found.group()),
                         source)


def functions(source):
    """Yields (line, length, declaration) of every function of a source.

    The line, counted from 1, is that of the opening brace; the length is the
    number of lines from there to the closing brace. What is defined inside of
    a function belongs to it.
    """
    code = without_text(source)
    scopes = []     # for every open brace: whether it encloses declarations
    function = None  # depth, line and declaration of the one that is open
    begin = 0       # of the declaration that is being read
    line = 1
    for position, character in enumerate(code):
        if character == "\n":
            line += 1
        elif character == "{":
            declaration = " ".join(code[begin:position].split())
            scopes.append(bool(_SCOPE.match(declaration)))
            is_function = "(" in declaration and not scopes[-1]
            if is_function and function is None and all(scopes[:-1]):
                function = (len(scopes), line, declaration)
            begin = position + 1
        elif character == "}":
            if function and function[0] == len(scopes):
                yield function[1], line - function[1], function[2]
                function = None
            if scopes:
                scopes.pop()
            begin = position + 1
        elif character == ";":
            begin = position + 1


def long_parts(texts):
    """Yields a line about every file and every function that is too long."""
    for path, text in texts.items():
        is_header = path.endswith(".h")
        allowed = MAX_HEADER_LINES if is_header else MAX_SOURCE_LINES
        lines = text.count("\n")
        if lines > allowed:
            yield f"{path}: {lines} lines, more than {allowed}"
        for line, length, declaration in functions(text):
            if length > MAX_FUNCTION_LINES and LIST not in declaration:
                yield (f"{path}:{line}: a function of {length} lines, more "
                       f"than {MAX_FUNCTION_LINES}: {declaration[:60]}")


def comment_counts(texts):
    """(comment lines, lines) of the headers, by folder."""
    counts = collections.defaultdict(lambda: [0, 0])
    for path, text in texts.items():
        if not path.endswith(".h") or not path.startswith(CODE_FOLDERS):
            continue
        lines = [line.strip() for line in text.splitlines()]
        lines = [line for line in lines if line and not line.startswith(
            ("// Copyright", "// SPDX-License-Identifier"))]
        folder = counts[str(pathlib.Path(path).parent)]
        folder[0] += sum(line.startswith("//") for line in lines)
        folder[1] += len(lines)
    return counts


def untested_units(paths):
    """The sources without a test of the same stem, and how many there are."""
    tests = {pathlib.Path(path).stem for path in paths
             if path.startswith("tests/")}
    units = [path for path in paths
             if path.endswith(".cc") and path.startswith(CODE_FOLDERS)]
    return [path for path in units
            if pathlib.Path(path).stem + "_test" not in tests], len(units)


def main():
    if len(sys.argv) > 1:
        sys.exit(__doc__)
    os.chdir(pathlib.Path(__file__).resolve().parent.parent)
    texts = {path: pathlib.Path(path).read_text(encoding="utf-8")
             for path in tracked_files()}
    if not texts:
        sys.exit("sizes: git lists no C++ files here")
    broken = list(long_parts(texts))

    untested, units = untested_units(texts)
    tested_share = 1 - len(untested) / units
    if tested_share < MIN_TESTED_SHARE:
        broken += [f"{path}: no test of the same stem" for path in untested]

    counts = comment_counts(texts)
    comment_share = (sum(comments for comments, _ in counts.values()) /
                     sum(lines for _, lines in counts.values()))
    if comment_share < MIN_COMMENT_SHARE:
        broken += [f"{folder}: {comments / lines:.1%} of the lines of the "
                   "headers are comments"
                   for folder, (comments, lines) in sorted(counts.items())
                   if comments / lines < MIN_COMMENT_SHARE]

    for complaint in broken:
        print(complaint, file=sys.stderr)
    print(f"sizes: {len(texts)} files, {tested_share:.1%} of {units} sources "
          f"with a test of the same stem (at least {MIN_TESTED_SHARE:.0%}), "
          f"{comment_share:.1%} of the lines of headers are comments (at least "
          f"{MIN_COMMENT_SHARE:.0%})" + ("" if broken else ", all well"))
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
