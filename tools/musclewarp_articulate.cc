// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "musclewarp/program/flags.h"
#include "musclewarp/program/program.h"
#include "tools/articulate_command.h"

namespace {

const musclewarp::ProgramText kText = {
    "musclewarp-articulate --out=DIR [--muscles=FILE,...] FILE... "
    "[flags]\n"
    "       musclewarp-articulate --out=DIR [--labels=TABLE] IMAGE "
    "[flags]\n\n"
    "Finds the joints of a skeleton on the shapes of its bones, of which the "
    "names of\nfiles or labels tell what they are (femur_r, hip_left, "
    "tibia). "
    "Writes to DIR an OpenSim\nmodel, motions, a report of the joints "
    "(joints.json) and a scene, so that\n\n"
    "    musclewarp-deform --scene=DIR/scene.json --out=...\n\n"
    "moves the muscles. A joint is good, weak (used, with the reason) or "
    "failed (its\nbone stays fixed).\n\n"
    "Exit code: 0 all joints good or weak, 1 one failed, 2 bad input.",
    {{"musclewarp-articulate --out=joints --html femur_r.ply tibia_r.ply "
      "hip_right.ply",
      "finds hip and knee, and writes joints.html to look at them"},
     {"musclewarp-articulate --out=joints --labels=table.csv scan.nii.gz",
      "takes bones and muscles from a label image"}},
    {"out", "muscles", "labels", "motion", "html"}};

}  // namespace

int main(int argc, char** argv) {
  using namespace musclewarp;
  ArticulateOptions options;
  RegisterFlags<SkeletonSettings>(&options);
  RegisterFlags<LabelSettings>(&options, {"pieces"});
  RegisterFlags<ArticulationSettings>(&options);
  RegisterFlags<ThreadSettings>(&options);
  return RunProgram(
      argc, argv, kText, [&](const std::vector<std::string>& files) {
        return ArticulateCommand(files, options, std::cout);
      });
}
