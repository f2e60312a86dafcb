// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/muscle_interior.h"

#include "musclewarp/fibres/found_attachments.h"
#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

// The number of fibres that resist bending: enough to have some in every part
// of a fan, and few, as each row is dense.
constexpr int kBendingFibres = 33;

}  // namespace

KnownEnds EndsOfFibres(const TriangleSoup& fine,
                       const std::vector<BodySurface>& bodies,
                       const SceneMuscle& muscle,
                       bool names_attachments) {
  if (names_attachments) return {muscle.attachments, muscle.lines};
  return {FindAttachments(fine,
                          bodies,
                          /*soft_parts=*/{},
                          muscle.lines,
                          EndExtent::kClearOfOther),
          muscle.lines};
}

MuscleInterior InteriorOf(const TriangleSoup& muscle,
                          const std::vector<BodySurface>& bodies,
                          const KnownEnds& ends,
                          const FibreOptions& options) {
  FibreOptions bending = options;
  bending.fibres = kBendingFibres;
  return {Centers(Voxelize(muscle, options.voxels)),
          MakeFibres(muscle, bodies, ends, bending)};
}

std::map<std::string, double> AreaOnBones(
    const TriangleSoup& muscle, const std::vector<BodySurface>& bodies) {
  const Eigen::VectorXd areas = VertexAreas(muscle.points, muscle.triangles);
  const auto near = VerticesNearBones(muscle.points, bodies);
  std::map<std::string, double> area_on_bones;
  for (size_t b = 0; b < bodies.size(); ++b) {
    if (near[b].empty()) continue;
    area_on_bones[bodies[b].body] = areas(near[b]).sum();
  }
  return area_on_bones;
}

}  // namespace musclewarp
