// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/subject/line_muscles.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "musclewarp/base/input_error.h"
#include "musclewarp/deformer/body_size.h"
#include "musclewarp/joints/articulated_scene.h"
#include "musclewarp/preparation/muscles_at_rest.h"
#include "musclewarp/scene/scaled_scene.h"
#include "musclewarp/scene/scene_checks.h"

namespace musclewarp {
namespace {

std::string BodyOfBone(const Articulation& articulation,
                       const std::string& name) {
  const auto bone = std::find_if(
      articulation.bones.begin(),
      articulation.bones.end(),
      [&](const Bone& candidate) { return candidate.name == name; });
  CHECK(bone != articulation.bones.end()) << name;
  return bone->body;
}

// Returns the scene of a subject on the bodies of its articulation.
Scene ArticulatedRestScene(const Subject& subject,
                           const Articulation& articulation,
                           double mm_per_unit) {
  Scene scene = SceneOfSubject(subject, mm_per_unit);
  for (SceneBone& bone : scene.bones) {
    bone.body = BodyOfBone(articulation, bone.name);
  }
  for (size_t m = 0; m < scene.muscles.size(); ++m) {
    const SubjectMesh& mesh = subject.muscles[m];
    scene.muscles[m].end_bodies =
        EndBodiesOf(articulation, mesh.name, mesh.origin, mesh.insertion);
  }
  return scene;
}

LineMuscles LineMusclesOf(Scene scene) {
  CheckScene(scene);
  scene = InBodyUnits(std::move(scene));
  PrepareOptions options;
  // As certified contact has it (Deformer).
  options.remove_self_crossings = true;
  options.remove_slivers = true;
  LineMuscles result;
  std::vector<MuscleAtRest> muscles = MusclesAtRest(scene, options);
  for (size_t m = 0; m < muscles.size(); ++m) {
    MuscleAtRest& muscle = muscles[m];
    for (std::string& warning : BareTendonWarnings(
             scene.muscles[m].name, muscle.bare_tendons, scene.body_size)) {
      result.warnings.push_back(std::move(warning));
    }
    const double volume = std::pow(scene.body_size, 3) * muscle.volume /
                          static_cast<double>(muscle.lines.size());
    for (ActionLine& line : muscle.lines) {
      ScaleLengths(scene.body_size, &line);
      result.muscles.push_back({std::move(line), volume});
    }
  }
  return result;
}

}  // namespace

LineMuscles LineMusclesOf(const Subject& subject,
                          const Articulation& articulation,
                          double mm_per_unit) {
  LineMuscles result;
  if (subject.muscles.empty()) return result;
  Scene scene = ArticulatedRestScene(subject, articulation, mm_per_unit);
  try {
    result = LineMusclesOf(std::move(scene));
  } catch (const InputError& error) {
    result.why_none = error.where() + ": " + error.problem();
  }
  return result;
}

}  // namespace musclewarp
