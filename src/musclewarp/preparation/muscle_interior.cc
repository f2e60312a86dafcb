// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/muscle_interior.h"

#include <cmath>
#include <utility>

#include "musclewarp/fibres/found_attachments.h"
#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/skeleton/covered_part.h"
#include "musclewarp/skeleton/sampling.h"

namespace musclewarp {
namespace {

// The number of fibres that resist bending: enough for every part of a fan, but
// few, because their rows are dense.
constexpr int kBendingFibres = 33;

void AddBeyond(const Points& points, double weight, InsidePoints* inside) {
  const Eigen::Index before = inside->beyond.rows();
  inside->beyond.conservativeResize(before + points.rows(), 3);
  inside->beyond.bottomRows(points.rows()) = points;
  inside->weights.conservativeResize(before + points.rows());
  inside->weights.tail(points.rows()).setConstant(weight);
}

}  // namespace

KnownEnds EndsOfFibres(const TriangleSoup& fine,
                       const std::vector<BodySurface>& bodies,
                       const SceneMuscle& muscle,
                       bool names_attachments) {
  if (names_attachments) return {muscle.attachments, muscle.lines};
  KnownEnds ends = {{}, muscle.lines};
  for (FoundAttachment& end :
       FindAttachments(fine, bodies, muscle.lines, EndExtent::kClearOfOther)) {
    ends.attachments.push_back(std::move(end.attachment));
  }
  return ends;
}

MuscleInterior InteriorOf(const TriangleSoup& muscle,
                          const std::vector<BodySurface>& bodies,
                          const KnownEnds& ends,
                          const std::vector<const TriangleSoup*>& beyond,
                          const FibreOptions& options) {
  FibreOptions bending = options;
  bending.fibres = kBendingFibres;
  const VoxelGrid grid = Voxelize(muscle, options.voxels);
  MuscleInterior interior;
  interior.points.own = Centers(grid);
  for (const TriangleSoup* other : beyond) {
    const VoxelGrid voxels = Voxelize(*other, options.voxels);
    AddBeyond(Centers(voxels),
              std::pow(voxels.size / grid.size, 3),
              &interior.points);
  }
  interior.fibres = MakeFibres(muscle, bodies, ends, bending);
  return interior;
}

EmbeddedLines CarryActionLines(const MuscleModel& model, double spacing) {
  std::vector<Points> lines(model.lines.size());
  const std::vector<SegmentPoint> samples = SamplesAlong(
      SampleLines(model.lines, spacing), model.lines, model.fine_rest);
  for (const SegmentPoint& sample : samples) {
    Points& line = lines[sample.line];
    line.conservativeResize(line.rows() + 1, 3);
    line.bottomRows<1>() =
        PointOnSegment(model.lines[sample.line].rest, sample);
  }
  return EmbedLines(lines, model.coarse_rest, model.coarse_triangles);
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
