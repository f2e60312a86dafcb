// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/program/flags.h"
#include "musclewarp/program/program.h"
#include "tools/compare_command.h"
#include "tools/convergence_command.h"
#include "tools/literature_command.h"
#include "tools/posture_command.h"

namespace musclewarp {
namespace {

const ProgramText kText = {
    "musclewarp-compare --scene=FILE [--out=DIR] [flags]\n"
    "musclewarp-compare --convergence --scene=FILE [--out=DIR] [flags]\n"
    "musclewarp-compare --posture=MESH --in=RUN --muscle=NAME [--frame=N] "
    "[--out=DIR]\n"
    "musclewarp-compare --literature=TABLE.csv --in=RUN [--out=DIR]\n\n"
    "Solves the poses of a scene with several solvers and puts iterations, "
    "times, cost,\nvolume, distance to the reference and intersections side "
    "by side.\nWith --convergence, solves them with hulls, samples and "
    "meshes of several sizes, and says\nhow far each shape is from that with "
    "the finest.\nWith --posture, compares a muscle of a frame with a mesh "
    "that was segmented in that\nposture: distances of the surfaces, volumes "
    "and their overlap.\nWith --literature, compares the moment arms of a run "
    "with measured ones.\nExit code: 0 the table is complete (a solver that "
    "failed is a row that says so),\n2 bad input.",
    {{"musclewarp-compare --scene=hip.json --frames=0:10 --out=compared",
      "solves eleven poses with all solvers"},
     {"musclewarp-compare --posture=bent.ply --in=run --muscle=psoas "
      "--frame=10",
      "compares a muscle of a frame with one that was segmented"},
     {"musclewarp-compare --literature=measured.csv --in=run",
      "compares the moment arms of a run with measured ones"}},
    {"scene", "out", "frames", "configurations", "contact"}};

// All settings of the program.
struct Settings {
  DeformOptions run;
  DeformerSettings deformer;
  CompareSettings compare;
  PostureOptions posture;
  LiteratureOptions literature;
  ConvergenceSettings convergence;
};

DeformOptions OptionsOf(Settings settings) {
  DeformOptions options = settings.run;
  settings.deformer.given = GivenFlags();
  options.deformer = OptionsOf(settings.deformer);
  options.deformer.frames.measures.vertex_gaps = false;  // not shown
  options.sources = OptionsOf(PartOf<SceneSettings>(options));
  options.out = settings.compare.out;
  options.command = CommandLine({});
  return options;
}

CompareOptions CompareOptionsOf(const Settings& settings) {
  CompareOptions options;
  options.deform = OptionsOf(settings);
  options.configurations = ParseConfigurations(settings.compare.configurations);
  for (SolverConfiguration& configuration : options.configurations) {
    SetIterationLimit(settings.deformer.max_iterations, &configuration);
  }
  options.contacts = ParseContacts(settings.compare.contact);
  options.repeat = settings.compare.repeat;
  return options;
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

LiteratureOptions LiteratureOptionsOf(const Settings& settings) {
  RefuseFlags({"scene",
               "motion",
               "frames",
               "frame",
               "muscle",
               "mesh",
               "posture",
               "configurations",
               "contact",
               "repeat",
               "convergence"},
              "cannot be used with --literature, which compares a run with a "
              "table",
              "leave one of them out");
  LiteratureOptions options = settings.literature;
  options.in = settings.posture.in;
  options.out = settings.compare.out;
  return options;
}

PostureOptions PostureOptionsOf(const Settings& settings) {
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
  PostureOptions options = settings.posture;
  options.out = settings.compare.out;
  options.repair = OptionsOf(settings.deformer).prepare.repair;
  return options;
}

ConvergenceOptions ConvergenceOptionsOf(const Settings& settings) {
  RefuseFlags({"configurations", "repeat"},
              "cannot be used with --convergence, which compares "
              "discretisations with one solver",
              "leave one of them out");
  ConvergenceOptions options;
  options.deform = OptionsOf(settings);
  options.deform.deformer.frames.contact =
      ParseConvergenceContact(settings.compare.contact);
  options.values = StudyValuesOf(settings.convergence);
  return options;
}

// Return true if --posture, or --convergence, is given. Throw InputError for
// flags that mean nothing without it.
bool ComparesPostures(const Settings& settings) {
  if (!settings.posture.posture.empty()) return true;
  RefuseFlags({"mesh", "frame", "muscle", "posture_spacing"},
              "needs --posture",
              "give the mesh that was segmented in the posture");
  RefuseFlags({"in"},
              "needs --posture or --literature",
              "give the mesh of a posture, or a table of measured arms");
  return false;
}

bool StudiesConvergence(const Settings& settings) {
  if (settings.convergence.convergence) return true;
  RefuseFlags(
      {"convergence_vertices", "convergence_spacing", "convergence_density"},
      "needs --convergence",
      "add it, or leave this flag out");
  return false;
}

int Run(const Settings& settings) {
  if (!settings.literature.literature.empty()) {
    return LiteratureCommand(LiteratureOptionsOf(settings), std::cout);
  }
  if (ComparesPostures(settings)) {
    return PostureCommand(PostureOptionsOf(settings), std::cout);
  }
  if (StudiesConvergence(settings)) {
    return ConvergenceCommand(ConvergenceOptionsOf(settings), std::cout);
  }
  return CompareCommand(CompareOptionsOf(settings), std::cout);
}

int Main(int argc, char** argv) {
  Settings settings;
  RegisterFlags<SceneSettings>(&settings.run);
  RegisterFlags(&settings.compare);
  RegisterFlags(&settings.convergence);
  RegisterFlags<PostureSettings>(&settings.posture);
  RegisterFlags<LiteratureSettings>(&settings.literature);
  RegisterFlags(&settings.deformer, {"contact", "solver", "fibres", "cache"});
  RegisterFlags<ThreadSettings>(&settings.run);
  return RunProgram(
      argc, argv, kText, [&](const std::vector<std::string>& arguments) {
        RefuseArguments(arguments);
        return Run(settings);
      });
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) { return musclewarp::Main(argc, argv); }
