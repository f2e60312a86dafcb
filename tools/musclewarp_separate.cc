// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <iostream>

#include "musclewarp/program/flags.h"
#include "musclewarp/program/program.h"
#include "tools/separate_command.h"

namespace {

const musclewarp::ProgramText kText = {
    "musclewarp-separate --out=DIR [--bone=FILE,...] FILE... [flags]\n"
    "       musclewarp-separate --out=DIR [--labels=TABLE] [--bone=NAME,...] "
    "IMAGE [flags]\n\n"
    "Moves the vertices of surface meshes as little as it takes for no two "
    "meshes to\ncross, while each keeps its volume. The meshes of --bone do "
    "not move. Reads .ply,\n.obj, .off, .stl, .vtk, and with VTK .vtp; "
    "repairs the meshes; writes all of\nthem to DIR/<name>.ply. "
    "FILE#NAME is an object of an .obj or a solid of an ASCII\n.stl.\n\n"
    "With VTK also takes one label image (.nii, .nii.gz, .img, .nrrd, .nhdr, "
    ".mha, "
    ".mhd,\n.mgz): each label becomes a closed surface with the volume of "
    "its "
    "voxels, in "
    "mm, in LPS (+x left,\n+y back, +z head), named by TABLE, a line a "
    "label: 3,femur,bone. Without a table\nall labels are taken, as "
    "label_3.\n\n"
    "Exit code: 0 separated, 1 not (the summary says why), 2 bad input.",
    {{"musclewarp-separate --out=apart --bone=femur.ply psoas.ply iliacus.ply",
      "separates two muscles from each other and from a bone"},
     {"musclewarp-separate --out=apart --labels=table.csv scan.nii.gz",
      "separates the labels of an image"}},
    {"out", "bone", "labels", "gap", "units"}};

}  // namespace

int main(int argc, char** argv) {
  using namespace musclewarp;
  SeparateOptions options;
  RegisterFlags<SeparationFiles>(&options);
  RegisterFlags<LabelSettings>(&options);
  RegisterFlags<SeparationSettings>(&options);
  RegisterFlags<ThreadSettings>(&options);
  return RunProgram(
      argc, argv, kText, [&](const std::vector<std::string>& files) {
        options.given = GivenFlags();
        options.is_terminal = isatty(STDOUT_FILENO);
        return SeparateCommand(files, options, std::cout);
      });
}
