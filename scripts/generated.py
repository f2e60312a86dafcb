#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Writes what follows from lists of fields: of figures (src/musclewarp/figures)
the tables of docs/report.md, the properties of python/musclewarp/_core.pyi and
the types of the report page; of settings (src/musclewarp/settings) the tables
of docs/settings.md and docs/separate.md, and the keywords of Python; of limits
(src/musclewarp/joints/joint_limits.h) the table of verdicts of docs/joints.md.

  scripts/generated.py [--check] [--build=build/release]

--check writes nothing and names the files that are not as they should be.
Exit code: 0 if all are (or were written), else 1.
"""

import argparse
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FIGURES, SETTINGS, LIMITS = (  # programs, in the build folder
    "tests/figures/describe_figures", "tests/settings/describe_settings",
    "tests/joints/describe_joint_limits")
REPORT = ROOT / "docs/report.md"
STUB = ROOT / "python/musclewarp/_core.pyi"
TYPES = ROOT / "tools/report/src/data/figures.ts"

# Properties that python/src/frames.cc makes by hand.
BY_HAND = {"name", "path_lengths", "attachments", "shape", "muscles"}
# Keywords that take more than their text: (type, default).
KEYWORDS_BY_HAND = {
    "joints": ("Union[str, Sequence[str]]", ()),
    "axes": ("Optional[str]", "LPS"),
    "given": ("Union[_Path, Mapping[str, Any], None]", None),
}
PYTHON = {"number": "float", "whole": "int", "bool": "bool", "text": "str",
          "place": "List[float]"}
TYPESCRIPT = {"number": "number", "whole": "number", "bool": "boolean",
              "text": "string", "place": "[number, number, number]"}


def table(fields):
    """Returns the rows of a table of docs/report.md."""
    lines = ["| key | unit | meaning |", "|---|---|---|"]
    for field in fields:
        text = field["text"][0].upper() + field["text"][1:] \
            if field["text"][0].islower() else field["text"]
        lines.append(f"| `{field['key']}` | {field['unit']} | {text} |")
    return lines


def limit_cell(sign, limit):
    """Returns "below 45 %", or "yes" for a sign without a measure."""
    if limit is None or sign["beyond"] == "yes":
        return "" if limit is None else "yes"
    return f"{sign['beyond']} {limit:g} {sign['unit']}"


def verdicts(joints):
    """Returns the rows of the table of verdicts of docs/joints.md."""
    lines = ["| joint | sign | weak | failed | usual cause | limits rest on |",
             "|---|---|---|---|---|---|"]
    for joint, signs in joints.items():
        for i, sign in enumerate(signs):
            cells = ["" if i else joint, sign["text"],
                     limit_cell(sign, sign["weak"]),
                     limit_cell(sign, sign["failed"]), sign["cause"],
                     sign["source"]]
            lines.append(
                "|" + "|".join(f" {cell} " if cell else " " for cell in cells)
                + "|")
    return lines


def settings_table(fields):
    """Returns the rows of a table of settings."""
    lines = ["| setting | unit | default | allowed | meaning |",
             "|---|---|---|---|---|"]
    for field in fields:
        default = field["default"]
        if isinstance(default, bool):
            default = str(default).lower()
        elif isinstance(default, float):
            default = f"{default:g}"
        lines.append(f"| `{field['key']}` | {field['unit']} | "
                     f"{'`' + str(default) + '`' if default != '' else ''} | "
                     f"{field['allowed']} | {field['text']} |")
    return lines


def keywords(fields, indent):
    """Returns the keywords of a function of Python."""
    lines = []
    for field in fields:
        kind, default = KEYWORDS_BY_HAND.get(field["key"],
                                             (None, field["default"]))
        if kind is None:
            kind = ('Union[str, "os.PathLike[str]"]'
                    if field["type"] == "path" else PYTHON[field["type"]])
        lines.append(f"{indent}{field['key']}: {kind} = "
                     + (repr(default) if not isinstance(default, str)
                        else json.dumps(default)) + ",")
    return lines


def python_type(kind):
    if isinstance(kind, list):
        return f"List[{python_type(kind[0])}]"
    if isinstance(kind, dict):
        (how, inner), = kind.items()
        return (f"Optional[{python_type(inner)}]" if how == "or_null" else
                f"Dict[str, {python_type(inner)}]")
    return PYTHON.get(kind, "Dict[str, Any]")


def properties(fields):
    """Returns the properties of a class of the stub."""
    lines = []
    for field in fields:
        # Whatever a frame is called, its own name is one of these.
        if field["name"] in BY_HAND and field["key"] != "name":
            continue
        lines += ["    @property",
                  f"    def {field['name']}(self) -> "
                  f"{python_type(field['type'])}: ..."]
    return lines


def typescript_type(kind):
    if isinstance(kind, list):
        inner = typescript_type(kind[0])
        return f"({inner})[]" if " " in inner else f"{inner}[]"
    if isinstance(kind, dict):
        (how, inner), = kind.items()
        return (f"{typescript_type(inner)} | null" if how == "or_null" else
                f"Record<string, {typescript_type(inner)}>")
    return TYPESCRIPT.get(kind, kind)


def types(structs):
    """Returns the file of types of the report page."""
    lines = ["// Copyright 2026 The musclewarp authors.",
             "// SPDX-License-Identifier: Apache-2.0", "",
             "// What report.json says of frames: docs/report.md explains it. "
             "Written by", "// scripts/generated.py from the lists of "
             "src/musclewarp/figures."]
    for name, fields in structs.items():
        lines += ["", f"export interface {name} {{"]
        for field in fields:
            mark = "?" if field["may_be_missing"] else ""
            lines.append(f"  {field['key']}{mark}: "
                         f"{typescript_type(field['type'])};")
        lines.append("}")
    return "\n".join(lines) + "\n"


def between_marks(text, begin, end, made_of):
    """Returns a text in which the lines between the marks are made anew;
    `begin` has a group with the name of a struct."""
    def made(match):
        return "\n".join([match.group(1), *made_of(match.group(2)),
                          match.group(3)])
    new, count = re.subn(f"({begin})\n.*?({end})", made, text, flags=re.S)
    if count == 0:
        sys.exit(f"generated: no mark {begin}")
    return new


def printed(program):
    """Returns the JSON that a program prints."""
    return json.loads(subprocess.run(
        [program], check=True, capture_output=True).stdout)


def generated_files(build):
    """Returns the files and what is to be in them."""
    figures, settings, limits = (printed(build / program) for program in
                                 (FIGURES, SETTINGS, LIMITS))
    files = {
        REPORT: between_marks(
            REPORT.read_text(encoding="utf-8"),
            r"<!-- fields of (\w+) -->", "<!-- end of fields -->",
            lambda name: ["", *table(figures[name]), ""]),
        STUB: between_marks(
            STUB.read_text(encoding="utf-8"),
            r"    # Fields of (\w+)\.", r"    # End of fields\.",
            lambda name: properties(figures[name])),
        TYPES: types(figures),
        ROOT / "docs/joints.md": between_marks(
            (ROOT / "docs/joints.md").read_text(encoding="utf-8"),
            r"<!-- signs of (\w+) -->", "<!-- end of signs -->",
            lambda _: ["", *verdicts(limits), ""]),
    }
    for path in (ROOT / "docs/settings.md", ROOT / "docs/separate.md"):
        files[path] = between_marks(
            path.read_text(encoding="utf-8"),
            r"<!-- settings of (\w+) -->", "<!-- end of settings -->",
            lambda name: ["", *settings_table(settings[name]), ""])
    for name in ("_deformer", "_functions", "_joints", "_labels"):
        path = ROOT / f"python/musclewarp/{name}.py"
        text = path.read_text(encoding="utf-8")
        indent = re.search(r"( +)# Settings of", text)[1]
        files[path] = between_marks(
            text, r" +# Settings of (\w+)\.", r" +# End of settings\.",
            lambda struct: keywords(settings[struct], indent))
    return files


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--build", type=pathlib.Path,
                        default=ROOT / "build/release")
    arguments = parser.parse_args()
    files = generated_files(arguments.build)
    stale = [path for path, text in files.items()
             if not path.exists() or path.read_text(encoding="utf-8") != text]
    for path in stale:
        print(f"{path.relative_to(ROOT)}: "
              + ("is not what scripts/generated.py writes" if arguments.check
                 else "written"))
        if not arguments.check:
            path.write_text(files[path], encoding="utf-8")
    return 1 if stale and arguments.check else 0


if __name__ == "__main__":
    sys.exit(main())
