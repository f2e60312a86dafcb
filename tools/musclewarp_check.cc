// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "musclewarp/program/flags.h"
#include "musclewarp/program/program.h"
#include "tools/check_command.h"

namespace {

const musclewarp::ProgramText kText = {
    "musclewarp-check [--bone=NAME,...] FILE|FOLDER... [flags]\n\n"
    "Reports on surface meshes as they are: defects, volume, "
    "self-intersections, and\nfor every two files the triangle pairs that "
    "cross (exact), the vertices of one\ninside the other and the depth of "
    "the deepest, or\nthe smallest distance of the two. A FOLDER stands for "
    "all its meshes, that of a frame\nfor those of the frame. Reads .ply, "
    ".obj, .off, .stl, .vtk, and with VTK .vtp.\n"
    "Exit code: 0 done, 1 meshes cross and --require_clean, or are nearer "
    "than --gap,\n2 bad input.",
    {{"musclewarp-check psoas.ply femur.ply",
      "tells the defects of two meshes, and where they cross"},
     {"musclewarp-check --require_clean out/frame_0010",
      "exits with 1 if meshes of a frame cross"}},
    {"bone", "gap", "require_clean", "json", "units"}};

}  // namespace

int main(int argc, char** argv) {
  using namespace musclewarp;
  CheckOptions options;
  RegisterFlags(&options);
  return RunProgram(
      argc, argv, kText, [&](const std::vector<std::string>& arguments) {
        return CheckCommand(arguments, options, std::cout);
      });
}
