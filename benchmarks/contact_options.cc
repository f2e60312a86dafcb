// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
//
// What the numbers that steer certified contact are worth: moves the muscles of
// a scene with one of them changed, and prints a row of a table.
//
//   contact_options SCENE.json DATA_ROOT [FIELD=VALUE ...]
//
// The first row has the defaults. A field is named as in its struct, such as
// reach=2 or relaxation.smoothing_length=4; without any all are listed.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/musclewarp.h"

namespace musclewarp {
namespace {

using Options = CertifiedContactOptions;
using Setter = std::function<void(double, Options*)>;

const std::map<std::string, Setter>& Setters() {
  static const std::map<std::string, Setter> kSetters = {
      {"gap", [](double x, Options* o) { o->step.gap = x; }},
      {"reach", [](double x, Options* o) { o->step.reach = x; }},
      {"sweeps", [](double x, Options* o) { o->step.sweeps = int(x); }},
      {"repair_sweeps",
       [](double x, Options* o) { o->step.repair_sweeps = int(x); }},
      {"max_rounds", [](double x, Options* o) { o->step.max_rounds = int(x); }},
      {"planes.search_fraction",
       [](double x, Options* o) { o->step.planes.search_fraction = x; }},
      {"planes.overlooked_fraction",
       [](double x, Options* o) { o->step.planes.overlooked_fraction = x; }},
      {"planes.max_planes_per_triangle",
       [](double x, Options* o) {
         o->step.planes.max_planes_per_triangle = int(x);
       }},
      {"relaxation.smoothing_length",
       [](double x, Options* o) { o->step.relaxation.smoothing_length = x; }},
      {"relaxation.strain_hardening",
       [](double x, Options* o) { o->step.relaxation.strain_hardening = x; }},
      {"relaxation.stretch_limit",
       [](double x, Options* o) { o->step.relaxation.stretch_limit = x; }},
      {"relaxation.rope_factor",
       [](double x, Options* o) { o->step.relaxation.rope_factor = x; }},
      {"relaxation.pressure_gain",
       [](double x, Options* o) { o->step.relaxation.pressure_gain = x; }},
      {"relaxation.full_sweep_interval",
       [](double x, Options* o) {
         o->step.relaxation.full_sweep_interval = int(x);
       }},
      {"relaxation.max_push",
       [](double x, Options* o) { o->step.relaxation.max_push = x; }},
      {"relaxation.room_decay",
       [](double x, Options* o) { o->step.relaxation.room_decay = x; }},
      {"relaxation.contact_distance",
       [](double x, Options* o) { o->step.relaxation.contact_distance = x; }},
      {"volume.max_steps",
       [](double x, Options* o) { o->step.volume.max_steps = int(x); }},
      {"volume.smoothing_passes",
       [](double x, Options* o) { o->step.volume.smoothing_passes = int(x); }},
      {"defects.stiffening",
       [](double x, Options* o) { o->step.defects.stiffening = x; }},
      {"defects.max_folded_fraction",
       [](double x, Options* o) { o->step.defects.max_folded_fraction = x; }},
      {"coarse_weight", [](double x, Options* o) { o->coarse_weight = x; }},
      {"samples_per_coarse_vertex",
       [](double x, Options* o) { o->samples_per_coarse_vertex = x; }},
      {"rest_sweeps", [](double x, Options* o) { o->rest_sweeps = int(x); }},
      {"separation.cell.voxel_size",
       [](double x, Options* o) { o->separation.cell.voxel_size = x; }},
      {"separation.step", [](double x, Options* o) { o->separation.step = x; }},
      {"separation.carry_radius",
       [](double x, Options* o) { o->separation.carry_radius = x; }}};
  return kSetters;
}

double Median(std::vector<double> values) {
  std::nth_element(
      values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// Moves through every third pose.
void PrintRow(const std::string& name,
              const Scene& scene,
              const Options& certified) {
  DeformerOptions options;
  options.frames.certified = certified;
  Deformer deformer(scene, options);
  std::vector<double> ms_per_step;
  int frames = 0, usable = 0, steps = 0, self_pairs = 0, folded = 0;
  double moved = 0, most_moved = 0, worst_volume = 0;
  StretchMeasures worst;  // each figure of its worst muscle and frame
  const size_t interval = scene.poses.size() > 12 ? 3 : 1;
  for (size_t i = 0; i < scene.poses.size(); i += interval) {
    const Frame frame = deformer.MoveTo(scene.poses[i]);
    ++frames;
    usable += frame.IsUsable();
    steps += frame.pose_steps;
    ms_per_step.push_back(frame.wall_ms / frame.pose_steps);
    worst_volume = std::max(worst_volume, frame.WorstVolumeError());
    for (const MuscleFrame& muscle : frame.muscles) {
      self_pairs = std::max(self_pairs, muscle.self_pairs);
      folded = std::max(folded, muscle.folded_triangles);
      moved += muscle.mean_contact_displacement /
               static_cast<double>(frame.muscles.size());
      most_moved = std::max(most_moved, muscle.max_contact_displacement);
      const StretchMeasures& stretch = muscle.shape.triangles;
      worst.quantile_999 = std::max(worst.quantile_999, stretch.quantile_999);
      worst.largest = std::max(worst.largest, stretch.largest);
      worst.largest_patch =
          std::max(worst.largest_patch, stretch.largest_patch);
    }
  }
  std::printf(
      "| %s | %d of %d | %d | %.0f | %.0f | %.2f | %.1f | %.2f | %.2f | %.2f | "
      "%d | %d | %.0e |\n",
      name.c_str(),
      usable,
      frames,
      steps,
      Median(ms_per_step),
      deformer.contact().prepare_ms,
      moved / frames,
      most_moved,
      worst.quantile_999,
      worst.largest,
      worst.largest_patch / 100,
      self_pairs,
      folded,
      worst_volume);
  std::fflush(stdout);
}

int Run(const std::vector<std::string>& arguments) {
  if (arguments.size() < 2) {
    std::cerr << "usage: contact_options SCENE.json DATA_ROOT [FIELD=VALUE "
                 "...]\nfields:\n";
    for (const auto& setter : Setters()) std::cerr << setter.first << "\n";
    return 2;
  }
  const Scene scene = ReadScene(arguments[0], arguments[1]);
  std::printf(
      "| | usable | steps | ms a step | preparation ms | moved by contact, "
      "mean mm | largest mm | stretch 99.9 %% | largest | patch beyond 2, cm2 "
      "| "
      "self pairs | folded | volume error |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  PrintRow("defaults", scene, {});
  for (size_t i = 2; i < arguments.size(); ++i) {
    const std::string& argument = arguments[i];
    const size_t equals = argument.find('=');
    const auto setter = Setters().find(argument.substr(0, equals));
    if (equals == std::string::npos || setter == Setters().end()) {
      throw InputError(
          argument, "is not FIELD=VALUE", "see the list of fields");
    }
    Options options;
    setter->second(std::atof(argument.c_str() + equals + 1), &options);
    std::string error;
    if (!options.IsValid(&error)) throw InputError(argument, error, "");
    PrintRow(argument, scene, options);
  }
  return 0;
}

}  // namespace
}  // namespace musclewarp

int main(int argc, char** argv) {
  try {
    return musclewarp::Run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const musclewarp::InputError& error) {
    std::cerr << "contact_options: " << error.what() << "\n";
    return 2;
  }
}
