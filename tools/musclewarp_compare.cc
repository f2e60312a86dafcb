// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>

#include <iostream>

#include "tools/compare_command.h"
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
DEFINE_string(out,
              "",
              "folder for comparison.csv, comparison.json and history.csv; "
              "without it the table is only printed");
DEFINE_int32(repeat, 1, "runs of each, of which the median time is given");

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

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-compare --scene=FILE [--out=DIR] [flags]\n\n"
      "Solves the poses of a scene with several solvers and puts iterations, "
      "times, cost,\nvolume, distance to the reference and intersections side "
      "by side.\nExit code: 0 the table is complete (a solver that failed is a "
      "row that says so),\n2 bad input.",
      [](const std::vector<std::string>& arguments) {
        musclewarp::RefuseArguments(arguments);
        return musclewarp::CompareCommand(musclewarp::OptionsFromFlags(),
                                          std::cout);
      });
}
