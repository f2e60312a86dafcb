// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/body_size.h"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/base/text.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/preparation/delivered_mesh.h"
#include "musclewarp/scene/coordinate_limits.h"
#include "musclewarp/scene/length_unit.h"
#include "musclewarp/scene/scaled_scene.h"

namespace musclewarp {
namespace {

// Cube roots of volumes, mm: of human muscles, and those of a leg.
constexpr double kLeastOfHuman = 16, kMostOfHuman = 100;
constexpr double kLeastOfLeg = 31;

// Returns the volume of a mesh as delivered, mm^3: open or inside out as it may
// be, it need not be exact.
double RoughVolume(TriangleSoup mesh) {
  if (mesh.triangles.rows() == 0) return 0;
  mesh.points.rowwise() -= mesh.points.colwise().mean().eval();
  return std::abs(SignedVolume(mesh.points, mesh.triangles));
}

}  // namespace

double BodySizeOf(const Scene& scene) {
  std::vector<double> volumes(scene.muscles.size());
  ParallelFor(volumes.size(), [&](size_t m) {
    const SceneMuscle& muscle = scene.muscles[m];
    std::vector<std::string> notes;  // the preparation gives them
    TriangleSoup mesh = DeliveredMesh(muscle, &notes);
    const std::string& where =
        muscle.mesh_path.empty() ? muscle.name : muscle.mesh_path;
    CheckCoordinates(where, mesh.points);
    // A mesh in a wrong unit is not a small body.
    CheckMuscleSize(where,
                    BoundingBoxDiagonal(mesh.points),
                    std::nullopt,
                    muscle.mm_per_unit);
    volumes[m] = RoughVolume(std::move(mesh));
  });
  double sum = 0;
  int count = 0;
  for (const double volume : volumes) {
    if (!(volume > 0) || !std::isfinite(volume)) continue;
    sum += std::log2(volume);
    ++count;
  }
  if (count == 0) return 1;
  const double size = std::exp2(sum / (3 * count));
  if (size >= kLeastOfHuman && size < kMostOfHuman) return 1;
  return std::exp2(std::floor(std::log2(size / kLeastOfLeg)));
}

Scene InBodyUnits(Scene scene) {
  scene.body_size = BodySizeOf(scene);
  if (scene.body_size == 1) return scene;
  ScaleLengths(1 / scene.body_size, &scene);
  scene.notes.push_back(
      "the muscles are " + BodySizeText(scene.body_size) +
      " human size; lengths that the method uses, such as the gap, are scaled "
      "accordingly unless they are given");
  return scene;
}

}  // namespace musclewarp
