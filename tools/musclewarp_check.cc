// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>

#include <iostream>

#include "tools/check_command.h"
#include "tools/flag_values.h"
#include "tools/program.h"
#include "tools/split.h"

DEFINE_string(json, "", "file to write all figures to");
DEFINE_bool(require_clean,
            false,
            "exit with 1 if any two meshes cross or contain each other");
DEFINE_double(gap,
              0,
              "mm; exit with 1 if any two meshes are nearer to each other");
DEFINE_string(
    bone,
    "",
    "which meshes are bones, commas: names of the files given, without "
    "extension, or more files; that two bones cross, or are near each "
    "other, does not change the exit code");
DEFINE_string(units, "mm", "unit of the files: mm, cm, m");
DEFINE_int32(threads, 0, "threads; 0: one a core");

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-check [--bone=NAME,...] FILE|FOLDER... [flags]\n\n"
      "Reports on surface meshes as they are: defects, volume, "
      "self-intersections, and\nfor every two files the triangle pairs that "
      "cross (exact), the vertices of one\ninside the other and the depth of "
      "the deepest, or\nthe smallest distance of the two. A FOLDER stands for "
      "all its meshes, that of a frame\nfor those of the frame. Reads .ply, "
      ".obj, .off, .stl, .vtk, and with VTK .vtp.\n"
      "Exit code: 0 done, 1 meshes cross and --require_clean, or are nearer "
      "than --gap,\n2 bad input.",
      [](const std::vector<std::string>& files) {
        musclewarp::CheckOptions options;
        options.json = FLAGS_json;
        options.require_clean = FLAGS_require_clean;
        options.gap = FLAGS_gap;
        options.bones = musclewarp::Split(FLAGS_bone, ',');
        options.mm_per_unit = musclewarp::ParseUnits(FLAGS_units);
        options.threads = FLAGS_threads;
        return musclewarp::CheckCommand(files, options, std::cout);
      });
}
