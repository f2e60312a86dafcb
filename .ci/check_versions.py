#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Fails when files of this repository name different versions of it.

usage: .ci/check_versions.py [--release]

CMakeLists.txt has the version. CITATION.cff and the latest release of CHANGELOG.md
have to have the same version and one date, README.md the names of the files of that
version, the cohorts and the project that tests an install the version as well.
With --release, CHANGELOG.md may not have an open part ("## Unreleased").
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent


def found(path, pattern):
    """What the groups of a pattern match first in a file, as one text or several."""
    match = re.search(pattern, (ROOT / path).read_text(encoding="utf-8"), re.M)
    if not match:
        sys.exit(f"versions: {path} has no line like {pattern}")
    return match[1] if len(match.groups()) == 1 else match.groups()


def problems(is_release):
    """Yields a line about each place that has to be mended."""
    version = found("CMakeLists.txt", r"^project\(musclewarp VERSION ([0-9.]+)")
    released, date = found("CHANGELOG.md",
                           r"^## ([0-9.]+) — ([0-9]{4}-[0-9]{2}-[0-9]{2})$")
    other = {
        "CITATION.cff": found("CITATION.cff", r"^version: ([0-9.]+)$"),
        "CHANGELOG.md, the latest release": released,
        "README.md, the name of the bundle":
            found("README.md", r"musclewarp-([0-9.]+)-linux-x86_64"),
        "cohort/musclewarp_cohort/__init__.py":
            found("cohort/musclewarp_cohort/__init__.py", r'^VERSION = "(.*)"$'),
    }
    for place, text in other.items():
        if text != version:
            yield f"{place}: {text}, and CMakeLists.txt has {version}: make them one"
    wanted = found("tests/install/CMakeLists.txt", r"find_package\(musclewarp ([0-9.]+)")
    if wanted != ".".join(version.split(".")[:2]):
        yield (f"tests/install/CMakeLists.txt asks for {wanted}, and CMakeLists.txt has "
               f"{version}: ask for its first two numbers")
    cited = found("CITATION.cff", r"^date-released: (.*)$")
    if cited != date:
        yield (f"CITATION.cff has the date {cited}, and CHANGELOG.md {date} for "
               f"{released}: make them one")
    first = found("CHANGELOG.md", r"^## (.*)$")
    if is_release and first != f"{released} — {date}":
        yield (f'CHANGELOG.md begins with "## {first}": call it "## VERSION — DATE", as '
               "the parts below are called")


def main(arguments):
    if arguments not in ([], ["--release"]):
        sys.exit(__doc__)
    told = list(problems(bool(arguments)))
    for line in told:
        print(f"versions: {line}", file=sys.stderr)
    if told:
        return 1
    print("versions: all files agree")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
