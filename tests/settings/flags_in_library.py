#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Names the texts of the library that have flags in them: it calls settings
"{max_hole}", as only programs know them as flags (base/setting_names.h). The
folder program/, which reads command lines and prints help, is left out.

usage: flags_in_library.py ROOT
"""
import pathlib
import re
import sys

TEXT = re.compile(r'"(?:[^"\\]|\\.)*"')
FLAG = re.compile(r"(?<![\w<!-])--[a-z]")


def main():
    root = pathlib.Path(sys.argv[1])
    found = 0
    for folder in ("src", "problems"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cc"):
                continue
            if path.parent.name == "program":
                continue
            lines = path.read_text(encoding="utf-8").split("\n")
            for number, line in enumerate(lines, start=1):
                if line.lstrip().startswith("//"):
                    continue
                for text in TEXT.findall(line):
                    if FLAG.search(text):
                        print(f"{path.relative_to(root)}:{number}: {text}")
                        found += 1
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
