// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/scene_lines.h"

#include <algorithm>
#include <utility>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/fibres/fibres.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

// Returns the indices of the muscles that the scene says a muscle ends on.
std::optional<std::vector<int>> NamedEnds(const SceneMuscle& muscle,
                                          const Scene& scene) {
  if (!muscle.ends_on) return std::nullopt;
  std::vector<int> ends_on;
  for (const std::string& name : *muscle.ends_on) {
    const auto named = std::find_if(
        scene.muscles.begin(), scene.muscles.end(), [&](const auto& other) {
          return other.name == name;
        });
    if (named == scene.muscles.end()) continue;  // CheckScene refuses it
    ends_on.push_back(static_cast<int>(named - scene.muscles.begin()));
  }
  return ends_on;
}

}  // namespace

bool LacksLines(const Scene& scene) {
  return std::any_of(
      scene.muscles.begin(),
      scene.muscles.end(),
      [](const SceneMuscle& muscle) { return muscle.lines.empty(); });
}

std::vector<ContinuedLines> MakeSceneLines(
    const Surroundings& surroundings,
    int lines_each,
    const std::function<void(size_t)>& on_done,
    const Scene& scene) {
  const size_t count = scene.muscles.size();
  std::vector<ContinuedLines> made(count);
  if (!LacksLines(scene)) return made;
  std::vector<SoftPart> parts(count);
  const auto make = [&](size_t m) {
    const SceneMuscle& muscle = scene.muscles[m];
    const TriangleSoup& mesh = surroundings.muscle(m);
    SoftPart& part = parts[m];
    part.surface = &surroundings.surface_of(m);
    part.volume = SignedVolume(mesh.points, mesh.triangles);
    part.lines = !muscle.lines.empty() ? muscle.lines
                                       : MakeLines(muscle.name,
                                                   mesh,
                                                   surroundings.bodies(),
                                                   muscle.attachments,
                                                   lines_each);
    part.ends =
        EndsOf(muscle, FindAttachments(mesh, surroundings.bodies(), {}));
    part.ends_on = NamedEnds(muscle, scene);
  };
  ParallelFor(count, make, on_done);
  FindSoftEnds(&parts);
  for (size_t m = 0; m < count; ++m) {
    if (!scene.muscles[m].lines.empty()) continue;
    made[m] = ContinueLines(static_cast<int>(m), parts, surroundings.bodies());
  }
  return made;
}

}  // namespace musclewarp
