#!/usr/bin/python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Tells functions that leave the upper halves of wide registers in use.

Code for registers of 128 bits, as most of ours, takes up to twice as long until
they are emptied (vzeroupper). Compilers empty them where a function ends; GCC 12
forgets it before a call that ends one. Functions are read from top to bottom, as
objdump prints them, those of musclewarp alone.

usage: .ci/check_wide_registers.py [PROGRAM]    build/release/tools/musclewarp-deform
"""

import pathlib
import platform
import re
import shutil
import subprocess
import sys

HEAD = re.compile(r"^[0-9a-f]+ <(.*)>:$")
LEAVES = re.compile(r"\t(?:ret|call|jmp)\b(.*)")


def leaves_dirty(name, lines):
    """Returns the first line that leaves a function with registers in use."""
    is_dirty = False
    for line in lines:
        if "vzeroupper" in line or "vzeroall" in line:
            is_dirty = False
        elif "%ymm" in line or "%zmm" in line:
            is_dirty = True
        leaves = LEAVES.search(line)
        if not (leaves and is_dirty):
            continue
        # Parts of a function that are seldom reached are apart: name.cold.
        target = re.search(r"<([^+>]*)", leaves[1])
        if target is None or target[1].removesuffix(".cold") != name:
            return line.strip()
    return None


def functions(program):
    """Yields (name, lines) of each function of a program."""
    with subprocess.Popen(
        ["objdump", "-d", "--no-show-raw-insn", program],
        stdout=subprocess.PIPE,
        text=True,
    ) as dump:
        name, lines = None, []
        for line in dump.stdout:
            head = HEAD.match(line.rstrip())
            if head:
                if name:
                    yield name, lines
                name, lines = head[1], []
            else:
                lines.append(line)
        if name:
            yield name, lines
    if dump.returncode != 0:
        sys.exit(f"wide registers: objdump cannot read {program}")


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    program = root / "build/release/tools/musclewarp-deform"
    if len(sys.argv) == 2:
        program = pathlib.Path(sys.argv[1])
    elif len(sys.argv) > 2:
        sys.exit(__doc__)
    if platform.machine() != "x86_64" or shutil.which("objdump") is None:
        print("wide registers: not checked, without x86_64 or objdump")
        return
    wide, bad = 0, []
    for name, lines in functions(program):
        if "musclewarp" not in name or not any("%ymm" in line for line in lines):
            continue
        wide += 1
        line = leaves_dirty(name, lines)
        if line:
            bad.append(f"{name} leaves them in use: {line}")
    if bad:
        print("\n".join(bad))
        sys.exit("wide registers: call _mm256_zeroupper() before (row_products.cc)")
    print(f"wide registers: {wide} functions, all well")


if __name__ == "__main__":
    main()
