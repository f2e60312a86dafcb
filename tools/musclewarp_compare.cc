// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>

#include <iostream>
#include <string>

#include "musclewarp/base/input_error.h"
#include "tools/compare_command.h"
#include "tools/posture_command.h"
#include "tools/program.h"
#include "tools/scene_flags.h"

DEFINE_string(configurations,
              "all",
              "solvers to compare: all, or names with commas: reference, ceres "
              "(whitened unknowns), and plain blocks with "
              "ceres_dense_cholesky, ceres_sparse_cholesky, ceres_cgnr, "
              "ceres_dogleg");
DEFINE_string(contact,
              "none",
              "none, paper, certified, or several with commas");
DEFINE_string(
    out,
    "",
    "folder for comparison.csv, comparison.json and history.csv, or for "
    "posture.json and posture.vtp; "
    "without it the table is only printed");
DEFINE_int32(repeat, 1, "runs of each, of which the median time is given");
DEFINE_string(posture,
              "",
              "mesh of a muscle as segmented in a posture, with which --mesh, "
              "or --muscle in a --frame of --in, is compared");
DEFINE_string(mesh, "", "with --posture: mesh file to compare");
DEFINE_string(in, "", "with --posture: folder of a run of musclewarp-deform");
DEFINE_string(frame,
              "",
              "with --posture: frame of --in, last or a number; without it the "
              "last");
DEFINE_string(muscle, "", "with --posture: muscle of --in to compare");
DEFINE_double(posture_spacing,
              0,
              "with --posture: largest distance of the places of a surface "
              "that are compared, mm; 0: the diagonal over 300");

namespace musclewarp {
namespace {

CompareOptions OptionsFromFlags() {
  CompareOptions options;
  options.deform = SceneOptionsFromFlags();
  options.deform.out = FLAGS_out;
  options.configurations = ParseConfigurations(FLAGS_configurations);
  for (SolverConfiguration& configuration : options.configurations) {
    SetIterationLimit(&configuration);
  }
  options.contacts = ParseContacts(FLAGS_contact);
  options.repeat = FLAGS_repeat;
  return options;
}

bool IsGiven(const char* flag) {
  return !gflags::GetCommandLineFlagInfoOrDie(flag).is_default;
}

PostureOptions PostureOptionsFromFlags() {
  for (const char* flag :
       {"scene", "motion", "frames", "configurations", "contact", "repeat"}) {
    if (!IsGiven(flag)) continue;
    throw InputError(std::string("--") + flag,
                     "cannot be used with --posture, which compares meshes",
                     "leave one of them out");
  }
  return {FLAGS_posture,
          FLAGS_mesh,
          FLAGS_in,
          FLAGS_frame,
          FLAGS_muscle,
          FLAGS_out,
          FLAGS_posture_spacing,
          SceneOptionsFromFlags().deformer.prepare.repair};
}

// Throws InputError for flags that mean nothing without --posture.
bool ComparesPostures() {
  if (!FLAGS_posture.empty()) return true;
  for (const char* flag :
       {"mesh", "in", "frame", "muscle", "posture_spacing"}) {
    if (!IsGiven(flag)) continue;
    throw InputError(std::string("--") + flag,
                     "needs --posture",
                     "give the mesh that was segmented in the posture");
  }
  return false;
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-compare --scene=FILE [--out=DIR] [flags]\n"
      "musclewarp-compare --posture=MESH --in=RUN --muscle=NAME [--frame=N] "
      "[--out=DIR]\n\n"
      "Solves the poses of a scene with several solvers and puts iterations, "
      "times, cost,\nvolume, distance to the reference and intersections side "
      "by side.\nWith --posture, compares a muscle of a frame with a mesh that "
      "was segmented in that\nposture: distances of the surfaces, volumes and "
      "their overlap.\nExit code: 0 the table is complete (a solver that "
      "failed is a "
      "row that says so),\n2 bad input.",
      [](const std::vector<std::string>& arguments) {
        musclewarp::RefuseArguments(arguments);
        if (musclewarp::ComparesPostures()) {
          return musclewarp::PostureCommand(
              musclewarp::PostureOptionsFromFlags(), std::cout);
        }
        return musclewarp::CompareCommand(musclewarp::OptionsFromFlags(),
                                          std::cout);
      });
}
