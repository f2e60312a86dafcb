#!/usr/bin/env python3
# Copyright 2026 The musclewarp authors.
# SPDX-License-Identifier: Apache-2.0
"""Changes each place of the table "Where would you change ..." of CONTRIBUTING.md
a little, and sees whether programs then write something else.

  scripts/check_places.py [--only=WORDS]

A row leads somewhere if every file that it names is there, and a change of each
makes a difference on the embedded scene. A row of the table that has no change
here, or the other way round, leads nowhere. --only takes the rows with these
words.

Everything happens in the copy of the last commit that scripts/mutants.py has,
too (build/mutants). It takes twelve minutes on two cores, and the first run has to
build the copy. Export to finite elements needs tetgen.

Exit code: 0 if all rows lead somewhere, else 1.
"""

import argparse
import dataclasses
import pathlib
import re
import shutil
import sys
import tempfile

import probes
from commit_copy import (COPY, builds, changed, check_out, configure_and_build)

LIBRARY = "src/musclewarp/"
COMMENTED = LIBRARY + "base/content_hash.cc"


@dataclasses.dataclass(frozen=True)
class Change:
    """What stands in a file, what takes its place, and who has to notice:
    functions of probes.py, all of them."""

    file: str
    before: str
    after: str
    noticed_by: tuple

    def of_text(self, text):
        if text.count(self.before) != 1:
            sys.exit(f"check_places: {self.file} should have this once:\n"
                     f"{self.before}")
        return text.replace(self.before, self.after)


# By the first column of the table.
CHANGES = {
    "the gap kept between muscles": [
        Change(LIBRARY + "certified_contact/step_options.h",
               "double gap = 0.1;", "double gap = 0.2;", (probes.certified,))],
    "a new setting": [
        Change(LIBRARY + "settings/deformer_settings.h",
               "= MuscleModelOptions().skeleton_weight;",
               "= 2 * MuscleModelOptions().skeleton_weight;",
               (probes.certified,)),
        Change(LIBRARY + "settings/deformer_settings.cc",
               "muscle->attachment_weight = settings.attachment_weight;",
               "muscle->attachment_weight = 2 * settings.attachment_weight;",
               (probes.certified,))],
    "which frames count as usable": [
        Change(LIBRARY + "certificate/shortcomings.h",
               "double max_stretch = 20;", "double max_stretch = 1.05;",
               (probes.certified,))],
    "how a plane between two triangles is found": [
        Change(LIBRARY + "proximity/triangle_separation.cc",
               "(closest.on_a - closest.on_b) / distance, distance};",
               "(closest.on_a - closest.on_b) / distance, distance / 2};",
               (probes.certified,))],
    "a new figure": [
        Change(LIBRARY + "figures/frame_figures.h",
               "return shortcomings.empty() &&", "return !shortcomings.empty() &&",
               (probes.certified,)),
        Change(LIBRARY + "frames/frame_measures.cc",
               "frame.volume_error = volume / model.rest_volume - 1;",
               "frame.volume_error = volume / model.rest_volume - 2;",
               (probes.certified,))],
    "a new mesh format": [
        Change(LIBRARY + "mesh_files/off_io.cc",
               "cursor_.Real(words_[at_ + k], \"a coordinate\")",
               "1.01 * cursor_.Real(words_[at_ + k], \"a coordinate\")",
               (probes.bone_as_off,)),
        Change(LIBRARY + "mesh_files/mesh_io.cc",
               "      {\".off\", ReadQuietly<ReadOff>, OffBytes},\n", "",
               (probes.bone_as_off,))],
    "a new format for finite elements": [
        Change(LIBRARY + "exchange/abaqus_file.cc", "*HEADING\\n",
               "*HEADING\\nchanged, ", (probes.elements,)),
        Change("tools/export_elements.cc", "      {\"inp\", AbaqusText},\n", "",
               (probes.elements,))],
    "a new term of the energy": [
        Change(LIBRARY + "solver/muscle_model.cc",
               "weights.push_back(options.attachment_weight /",
               "weights.push_back(2 * options.attachment_weight /",
               (probes.certified, probes.paper, probes.free_ceres,
                probes.free_reference)),
        Change(LIBRARY + "solver/muscle_target.cc",
               "        model.skeleton_weight *\n",
               "        1.01 * model.skeleton_weight *\n",
               (probes.certified, probes.paper, probes.free_ceres,
                probes.free_reference))],
    "the same as a Ceres cost function, for the other configurations of "
    "`musclewarp-compare`": [
        Change("problems/single_muscle/laplacian_term.h",
               "residual[k] = T(-delta[k]);",
               "residual[k] = T(-1.01 * delta[k]);", (probes.compared,)),
        Change("problems/single_muscle/single_muscle_problem.cc",
               "    AddCoordinatesTerms(model.attachment, target.attachment, "
               "blocks, problem);\n", "", (probes.compared,))],
    "what follows a step after which triangles cross": [
        Change(LIBRARY + "motion/step_remedies.cc",
               "{Remedy::kHalve,\n        Remedy::kGoBack,",
               "{Remedy::kGoBack,", (probes.crossing_steps,))],
}


def rows_of_table():
    """Returns {what: [the files that the row names]}."""
    text = (COPY / "CONTRIBUTING.md").read_text(encoding="utf-8")
    table = text.split("| what | where |\n|---|---|\n")[1].split("\n\n")[0]
    rows = {}
    for line in table.splitlines():
        what, where = (cell.strip() for cell in line.strip("| ").split(" | "))
        folder = pathlib.Path()
        rows[what] = []
        for name in re.findall(r"`([\w./]+\.(?:cc|h))`", where):
            # "beside it" is in the folder of the file before.
            path = pathlib.Path(name) if "/" in name else folder / name
            folder = path.parent
            rows[what].append(str(path))
    return rows


def what_is_wrong(change, unchanged, scratch):
    """Returns why a change leads nowhere, or nothing."""
    with changed(change.file, change.of_text):
        programs = {probe.program for probe in change.noticed_by}
        if not builds(sorted(programs)):
            return "does not compile when changed"
        for probe in change.noticed_by:
            if probe.output(scratch) == unchanged[probe]:
                return f"makes no difference to {probe.name}"
    return ""


def outputs_without_a_change(needed, scratch):
    """Returns the output of each probe. Exits if one fails, or says something
    else when a comment changes, and with it the hash of the code."""
    unchanged = {probe: probe.output(scratch) for probe in needed}
    for probe, output in unchanged.items():
        if not output.is_good:
            sys.exit(f"check_places: {probe.name} fails without a change:\n"
                     f"{output.said}")
    with changed(COMMENTED, lambda text: text + "// A comment.\n"):
        if not builds(sorted({probe.program for probe in needed})):
            sys.exit("check_places: a comment more does not compile")
        for probe in needed:
            if probe.output(scratch) != unchanged[probe]:
                sys.exit(f"check_places: {probe.name} does not repeat itself")
    return unchanged


def check_row(what, files, unchanged, scratch):
    """Prints a line on a row and returns whether it leads somewhere."""
    wrong = [f"{file} is not there" for file in files
             if not (COPY / file).is_file()]
    changes = CHANGES.get(what, [])
    named = {change.file for change in changes}
    wrong += [f"{file} has no change in check_places.py"
              for file in files if file not in named]
    wrong += [f"CONTRIBUTING.md does not name {file}"
              for file in sorted(named.difference(files))]
    for change in changes if not wrong else []:
        reason = what_is_wrong(change, unchanged, scratch)
        if reason:
            wrong.append(f"{change.file} {reason}")
    noticed_by = dict.fromkeys(probe.name for change in changes
                               for probe in change.noticed_by)
    print(f"NOWHERE  {what}: {'; '.join(wrong)}" if wrong else
          f"found    {what}: {'; '.join(noticed_by)}", flush=True)
    return not wrong


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--only", default="")
    only = parser.parse_args().only
    check_out()
    rows = rows_of_table()
    rows.update({what: [] for what in CHANGES if what not in rows})
    rows = {what: files for what, files in rows.items() if only in what}
    needed = dict.fromkeys(probe for what in rows
                           for change in CHANGES.get(what, [])
                           for probe in change.noticed_by)
    configure_and_build("programs", sorted({probe.program for probe in needed}
                                           | {"musclewarp-deform"}))
    scratch = pathlib.Path(tempfile.mkdtemp(prefix="check_places_"))
    try:
        probes.prepare(scratch)
        unchanged = outputs_without_a_change(needed, scratch)
        found = [check_row(what, files, unchanged, scratch)
                 for what, files in rows.items()]
    finally:
        shutil.rmtree(scratch)
    return 0 if found and all(found) else 1


if __name__ == "__main__":
    sys.exit(main())
