// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "musclewarp/program/flags.h"
#include "musclewarp/program/program.h"
#include "tools/check_command.h"

namespace {

constexpr char kUsage[] =
    "musclewarp-check [--bone=NAME,...] FILE|FOLDER... [flags]\n\n"
    "Reports on surface meshes as they are: defects, volume, "
    "self-intersections, and\nfor every two files the triangle pairs that "
    "cross (exact), the vertices of one\ninside the other and the depth of "
    "the deepest, or\nthe smallest distance of the two. A FOLDER stands for "
    "all its meshes, that of a frame\nfor those of the frame. Reads .ply, "
    ".obj, .off, .stl, .vtk, and with VTK .vtp.\n"
    "Exit code: 0 done, 1 meshes cross and --require_clean, or are nearer "
    "than --gap,\n2 bad input.";

}  // namespace

int main(int argc, char** argv) {
  using namespace musclewarp;
  CheckOptions options;
  RegisterFlags(&options);
  return RunProgram(
      argc, argv, kUsage, [&](const std::vector<std::string>& arguments) {
        return CheckCommand(arguments, options, std::cout);
      });
}
