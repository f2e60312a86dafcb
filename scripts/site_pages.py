#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes the pages of the site that are made from sources and programs.

usage: scripts/site_pages.py FOLDER PROGRAM...

FOLDER/cpp/ has the headers that musclewarp/musclewarp.h includes, itself or by
others (FOLDER/headers.txt lists them), FOLDER/programs.md what the programs say of
themselves, FOLDER/examples/index.md the examples for Python.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FACADE = "musclewarp/musclewarp.h"


def headers_behind(header):
    """The headers that a header includes, itself first, each once."""
    found, waiting = [], [header]
    while waiting:
        name = waiting.pop(0)
        path = ROOT / "src" / name
        if name in found or not path.exists():
            continue
        found.append(name)
        waiting += re.findall(r'^#include "(musclewarp/.*)"$',
                              path.read_text(), re.M)
    return found


def cpp_pages(headers):
    """The text of each page by its name: the index, and one a folder."""
    folders = {}
    for name in headers[1:]:
        folders.setdefault(pathlib.PurePath(name).parts[1], []).append(name)
    order = sorted(folders, key=lambda name: (name != "deformer", name))
    pages = {"index": "\n".join(
        ["# C++ reference", "",
         f"What `#include <{FACADE}>` brings, by folders of `src/musclewarp`. "
         "All is in the namespace `musclewarp`; the comments are those of the "
         "headers. Lengths are in millimetres, angles in radians. "
         "`Deformer`, in deformer.h, is where to begin.", "",
         "```{toctree}", ":maxdepth: 2", "", *order, "```", ""])}
    for folder in order:
        lines = [f"# {folder}", ""]
        for name in folders[folder]:
            lines += [f"## {pathlib.PurePath(name).name}", "",
                      "```{doxygenfile} " + name, "```", ""]
        pages[folder] = "\n".join(lines)
    return pages


def programs_page(programs):
    lines = ["# Programs", "", "What the programs say to `--help`.", ""]
    for program in programs:
        said = subprocess.run([program, "--help"], check=True, text=True,
                              stdout=subprocess.PIPE).stdout
        lines += [f"## {pathlib.Path(program).name}", "", "```text",
                  said.rstrip(), "```", ""]
    return "\n".join(lines)


def examples_page(scripts):
    lines = ["# Examples", ""]
    for script in scripts:
        lines += [f"## {script.name}", "", "```{literalinclude} " + script.name,
                  ":language: python", "```", ""]
    return "\n".join(lines)


def main(folder, *programs):
    folder = pathlib.Path(folder)
    headers = headers_behind(FACADE)
    (folder / "headers.txt").write_text(
        "\n".join(f"src/{name}" for name in headers) + "\n")
    (folder / "cpp").mkdir()
    for name, text in cpp_pages(headers).items():
        (folder / "cpp" / f"{name}.md").write_text(text)
    (folder / "programs.md").write_text(programs_page(programs))
    (folder / "examples" / "index.md").write_text(
        examples_page(sorted((folder / "examples").glob("*.py"))))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
