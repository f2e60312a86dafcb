// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/path_coordinates.h"

#include <algorithm>
#include <set>

#include "musclewarp/base/angles.h"
#include "musclewarp/base/input_error.h"
#include "musclewarp/base/near_name.h"

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

int CoordinateNamed(const Model& model,
                    const std::string& coordinate,
                    const std::string& where) {
  const int index = model.FindCoordinate(coordinate);
  if (index >= 0) return index;
  std::vector<std::string> known;
  for (const Coordinate& other : model.coordinates) known.push_back(other.name);
  throw InputError(
      where,
      "names \"" + coordinate + "\", which is no coordinate of " + model.path,
      DidYouMean(coordinate, known) + "check {model}");
}

CoordinateValues ModelValuesOf(const Model& model,
                               const FrameFigures& frame,
                               const std::string& where) {
  CoordinateValues values = DefaultValues(model);
  for (const auto& [name, value] : frame.coordinates) {
    const int index = CoordinateNamed(model, name, where);
    const bool is_angle =
        model.coordinates[index].kind == CoordinateKind::kRotational;
    values[index] = value * (is_angle ? kRadiansPerDegree : 1);
  }
  ApplyCouplers(model, &values);
  return values;
}

}  // namespace musclewarp
