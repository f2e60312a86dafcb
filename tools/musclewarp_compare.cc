// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gflags/gflags.h>

#include <iostream>
#include <string>

#include "musclewarp/base/input_error.h"
#include "tools/compare_command.h"
#include "tools/convergence_command.h"
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
DEFINE_string(out,
              "",
              "folder for comparison.csv, comparison.json and history.csv, for "
              "convergence.csv and convergence.json, or for posture.json and "
              "posture.vtp; "
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
DEFINE_bool(convergence,
            false,
            "compare discretisations instead of solvers: how far shapes are "
            "from those of the finest; with --contact=none or certified");
DEFINE_string(convergence_vertices,
              "100,200,300,600,1200,2400",
              "with --convergence: vertices of hulls to compare, about; empty: "
              "hulls are not studied");
DEFINE_string(convergence_spacing,
              "2.5,5,10,20,40",
              "with --convergence: distances of samples along a line to "
              "compare, mm; empty: samples are not studied");
DEFINE_string(convergence_density,
              "0.25,1,4",
              "with --convergence: numbers of triangles of muscle meshes to "
              "compare, as multiples of what they have: 0.25, 1, 4 and 16; "
              "empty: they are not studied");

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

// Throws InputError if one of the flags is given.
void RefuseFlags(const std::vector<const char*>& flags,
                 const std::string& problem,
                 const std::string& advice) {
  for (const char* flag : flags) {
    if (!IsGiven(flag)) continue;
    throw InputError(std::string("--") + flag, problem, advice);
  }
}

PostureOptions PostureOptionsFromFlags() {
  RefuseFlags({"scene",
               "motion",
               "frames",
               "configurations",
               "contact",
               "repeat",
               "convergence",
               "convergence_vertices",
               "convergence_spacing",
               "convergence_density"},
              "cannot be used with --posture, which compares meshes",
              "leave one of them out");
  return {FLAGS_posture,
          FLAGS_mesh,
          FLAGS_in,
          FLAGS_frame,
          FLAGS_muscle,
          FLAGS_out,
          FLAGS_posture_spacing,
          SceneOptionsFromFlags().deformer.prepare.repair};
}

ConvergenceOptions ConvergenceOptionsFromFlags() {
  RefuseFlags({"configurations", "repeat"},
              "cannot be used with --convergence, which compares "
              "discretisations with one solver",
              "leave one of them out");
  ConvergenceOptions options;
  options.deform = SceneOptionsFromFlags();
  options.deform.out = FLAGS_out;
  options.deform.deformer.frames.contact =
      ParseConvergenceContact(FLAGS_contact);
  options.values = {ParseConvergenceVertices(FLAGS_convergence_vertices),
                    ParseConvergenceSpacing(FLAGS_convergence_spacing),
                    ParseConvergenceDensity(FLAGS_convergence_density)};
  return options;
}

// Throw InputError for flags that mean nothing without --posture, and without
// --convergence.
bool ComparesPostures() {
  if (!FLAGS_posture.empty()) return true;
  RefuseFlags({"mesh", "in", "frame", "muscle", "posture_spacing"},
              "needs --posture",
              "give the mesh that was segmented in the posture");
  return false;
}

bool StudiesConvergence() {
  if (FLAGS_convergence) return true;
  RefuseFlags(
      {"convergence_vertices", "convergence_spacing", "convergence_density"},
      "needs --convergence",
      "add it, or leave this flag out");
  return false;
}

int Run() {
  if (ComparesPostures()) {
    return PostureCommand(PostureOptionsFromFlags(), std::cout);
  }
  if (StudiesConvergence()) {
    return ConvergenceCommand(ConvergenceOptionsFromFlags(), std::cout);
  }
  return CompareCommand(OptionsFromFlags(), std::cout);
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  return musclewarp::RunProgram(
      argc,
      argv,
      "musclewarp-compare --scene=FILE [--out=DIR] [flags]\n"
      "musclewarp-compare --convergence --scene=FILE [--out=DIR] [flags]\n"
      "musclewarp-compare --posture=MESH --in=RUN --muscle=NAME [--frame=N] "
      "[--out=DIR]\n\n"
      "Solves the poses of a scene with several solvers and puts iterations, "
      "times, cost,\nvolume, distance to the reference and intersections side "
      "by side.\nWith --convergence, solves them with hulls, samples and "
      "meshes of several "
      "sizes, and says\nhow far each shape is from that with the finest."
      "\nWith --posture, compares a muscle of a frame with a mesh that "
      "was segmented in that\nposture: distances of the surfaces, volumes and "
      "their overlap.\nExit code: 0 the table is complete (a solver that "
      "failed is a "
      "row that says so),\n2 bad input.",
      [](const std::vector<std::string>& arguments) {
        musclewarp::RefuseArguments(arguments);
        return musclewarp::Run();
      });
}
