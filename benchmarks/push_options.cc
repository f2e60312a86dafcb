// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the numbers of the push of bones are worth: where the muscles of a scene
// are without contact in its last pose when one of them is halved or doubled.
//
//   push_options SCENE.json DATA_ROOT
//
// Prints a row for each, with how far a vertex of each muscle is from where it
// is with the defaults: on the mean, and at most.

#include <cstdio>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/musclewarp.h"

namespace musclewarp {
namespace {

using Options = BonePushOptions;
using Scaler = std::function<void(double, Options*)>;

const std::vector<std::pair<std::string, Scaler>>& Scalers() {
  static const std::vector<std::pair<std::string, Scaler>> kScalers = {
      {"clearance", [](double x, Options* o) { o->clearance *= x; }},
      {"onset", [](double x, Options* o) { o->onset *= x; }},
      {"relative_stiffness",
       [](double x, Options* o) { o->relative_stiffness *= x; }},
      {"drag", [](double x, Options* o) { o->drag *= x; }},
      {"max_lag", [](double x, Options* o) { o->max_lag *= x; }},
      {"samples_per_coarse_vertex",
       [](double x, Options* o) {
         o->samples_per_coarse_vertex = int(o->samples_per_coarse_vertex * x);
       }},
      {"steps_per_pose",
       [](double x, Options* o) {
         o->steps_per_pose = int(o->steps_per_pose * x);
       }},
      {"field_spacing", [](double x, Options* o) { o->field_spacing *= x; }}};
  return kScalers;
}

Frame LastFrame(const Scene& scene, const Options& push) {
  DeformerOptions options;
  options.frames.contact = ContactKind::kNone;
  options.bone_push = push;
  return Deformer(scene, options).MoveTo(scene.poses.back());
}

void PrintRow(const std::string& name, const Frame& frame, const Frame& base) {
  std::printf("| %s |", name.c_str());
  for (size_t i = 0; i < frame.muscles.size(); ++i) {
    const Eigen::VectorXd distances =
        (frame.muscles[i].points - base.muscles[i].points).rowwise().norm();
    std::printf(" %.2f, %.1f |", distances.mean(), distances.maxCoeff());
  }
  std::printf("\n");
  std::fflush(stdout);
}

int Run(const std::vector<std::string>& arguments) {
  if (arguments.size() != 2) {
    std::cerr << "usage: push_options SCENE.json DATA_ROOT\n";
    return 2;
  }
  const Scene scene = ReadScene(arguments[0], arguments[1]);
  const Frame base = LastFrame(scene, {});
  std::string names = "| |", rule = "|---|";
  for (const MuscleFrame& muscle : base.muscles) {
    names += " " + muscle.name + " |";
    rule += "---|";
  }
  std::printf("%s\n%s\n", names.c_str(), rule.c_str());
  Options off;
  off.enabled = false;
  PrintRow("no push", LastFrame(scene, off), base);
  for (const auto& scaler : Scalers()) {
    for (const double factor : {0.5, 2.0}) {
      Options options;
      scaler.second(factor, &options);
      PrintRow("`" + scaler.first + "` " + (factor < 1 ? "halved" : "doubled"),
               LastFrame(scene, options),
               base);
    }
  }
  return 0;
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  try {
    return musclewarp::Run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const musclewarp::InputError& error) {
    std::cerr << "push_options: " << error.what() << "\n";
    return 2;
  }
}
