// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/path_coordinates.h"

#include <algorithm>
#include <set>

#include "musclewarp/opensim/kinematics.h"

namespace musclewarp {
namespace {

// Adds the bodies to which a muscle is attached. Muscles that end on each other
// are visited once.
void AddBodiesOfMuscle(const Model& model,
                       const FrameFigures& frame,
                       const std::string& name,
                       std::set<std::string>* visited,
                       std::set<int>* bodies) {
  if (!visited->insert(name).second) return;
  for (const MuscleFigures& muscle : frame.muscles) {
    if (muscle.name != name) continue;
    for (const AttachmentDrift& attachment : muscle.attachments) {
      const int body = model.FindBody(attachment.body);
      if (body >= 0) bodies->insert(body);
      AddBodiesOfMuscle(model, frame, attachment.body, visited, bodies);
    }
  }
}

}  // namespace

std::vector<int> BodiesOfPath(const Model& model,
                              const FrameFigures& frame,
                              const std::string& muscle,
                              const std::string& line) {
  std::set<int> bodies;
  if (const int index = model.FindMuscle(line); index >= 0) {
    for (const PathPoint& point : model.muscles[index].path) {
      if (point.body >= 0) bodies.insert(point.body);
    }
  }
  if (bodies.size() < 2) {
    std::set<std::string> visited;
    AddBodiesOfMuscle(model, frame, muscle, &visited, &bodies);
  }
  return {bodies.begin(), bodies.end()};
}

std::vector<int> CrossedCoordinates(const Model& model,
                                    const std::vector<int>& coordinates,
                                    const std::vector<int>& bodies) {
  std::vector<int> crossed;
  for (size_t k = 0; k < coordinates.size(); ++k) {
    const auto moved =
        std::count_if(bodies.begin(), bodies.end(), [&](int body) {
          return MovesBody(model, coordinates[k], body);
        });
    if (moved > 0 && moved < static_cast<std::ptrdiff_t>(bodies.size())) {
      crossed.push_back(static_cast<int>(k));
    }
  }
  return crossed;
}

}  // namespace musclewarp
