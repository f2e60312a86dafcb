// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/found_attachments.h"

#include <algorithm>
#include <map>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/fibres/attachment_outline.h"
#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/triangle.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// On how many voxels ends are found, as for fibres.
constexpr int kVoxels = 6000;
// Of an end without a bone, what is attached reaches so far from its tip, as a
// share of the length of the muscle.
constexpr double kTipShare = 0.1;
// A tip lies on another soft part if half of it is at most so far away, or in
// it, mm.
constexpr double kTouching = 1;

// The distance from a point to the nearest of several meshes, mm: zero inside
// of one, infinity if there is none.
double DistanceOutside(const std::vector<const TriangleBvh*>& meshes,
                       const RowVector3d& point) {
  double distance = kInfinity;
  for (const TriangleBvh* mesh : meshes) {
    const TriangleBvh::Closest closest = mesh->ClosestPoint(point);
    if (closest.triangle < 0) continue;
    const RowVector3d normal = AreaVector(mesh->corners(closest.triangle));
    if (normal.dot(point - closest.point) <= 0) return 0;
    distance = std::min(distance, closest.distance);
  }
  return distance;
}

// The vertices whose nearest voxel is one of `voxels`, which are ascending.
std::vector<int> VerticesAt(const std::vector<int>& voxels,
                            const VoxelGrid& grid,
                            const Points& points) {
  std::vector<int> vertices;
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const int voxel = grid.Nearest(points.row(v));
    if (std::binary_search(voxels.begin(), voxels.end(), voxel)) {
      vertices.push_back(static_cast<int>(v));
    }
  }
  return vertices;
}

// The largest set of `vertices` that edges connect, in rising order.
std::vector<int> LargestConnected(const std::vector<int>& vertices,
                                  const TriangleSoup& muscle) {
  std::vector<char> is_chosen(muscle.points.rows(), false);
  for (const int v : vertices) is_chosen[v] = true;
  DisjointSets sets(static_cast<int>(muscle.points.rows()));
  for (Eigen::Index f = 0; f < muscle.triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = muscle.triangles(f, k);
      const int b = muscle.triangles(f, (k + 1) % 3);
      if (is_chosen[a] && is_chosen[b]) sets.Join(a, b);
    }
  }
  std::map<int, std::vector<int>> members;
  for (const int v : vertices) members[sets.Find(v)].push_back(v);
  std::vector<int> largest;
  for (auto& [representative, set] : members) {
    if (set.size() > largest.size()) largest = std::move(set);
  }
  return largest;
}

// The part of the vertices that lies on the bones of a body, or in them. Empty
// if no bone is near.
std::vector<int> OnBones(const BodySurface& body,
                         const std::vector<int>& vertices,
                         const Points& points) {
  std::vector<double> distances;
  double nearest = kInfinity;
  for (const int v : vertices) {
    distances.push_back(DistanceOutside(body.bones, points.row(v)));
    nearest = std::min(nearest, distances.back());
  }
  std::vector<int> on_bones;
  if (nearest > kNearBone) return on_bones;
  for (size_t i = 0; i < vertices.size(); ++i) {
    if (distances[i] <= nearest + kAreaDepth) on_bones.push_back(vertices[i]);
  }
  return on_bones;
}

// The voxels around the tip of an end: the one farthest from the other end, and
// what is near it.
std::vector<int> TipOf(const MuscleEnd& end,
                       const MuscleEnd& other,
                       const VoxelGrid& grid) {
  const Eigen::VectorXd from_other = DistancesWithin(grid, other.voxels);
  const int tip = *std::max_element(
      end.voxels.begin(), end.voxels.end(), [&](int a, int b) {
        return from_other[a] < from_other[b];
      });
  const Eigen::VectorXd from_tip = DistancesWithin(grid, {tip});
  std::vector<int> voxels;
  for (int v = 0; v < grid.num_voxels(); ++v) {
    if (from_tip[v] <= kTipShare * from_tip.maxCoeff()) voxels.push_back(v);
  }
  return voxels;
}

bool LiesOnSoftPart(const std::vector<int>& vertices,
                    const Points& points,
                    const std::vector<const TriangleBvh*>& soft_parts) {
  size_t touching = 0;
  for (const int v : vertices) {
    touching += DistanceOutside(soft_parts, points.row(v)) <= kTouching;
  }
  return 2 * touching >= vertices.size();
}

}  // namespace

std::vector<Attachment> FindAttachments(
    const TriangleSoup& muscle,
    const std::vector<BodySurface>& bodies,
    const std::vector<const TriangleBvh*>& soft_parts,
    const std::vector<ActionLine>& lines,
    EndExtent extent) {
  const VoxelGrid grid = Voxelize(muscle, kVoxels);
  std::vector<Attachment> attachments;
  if (bodies.empty() || grid.num_voxels() < 2) return attachments;
  const MuscleEnds ends =
      FindMuscleEnds(muscle, grid, bodies, {{}, lines}, extent);
  for (const MuscleEnd* end : {&ends.origin, &ends.insertion}) {
    const auto body = std::find_if(
        bodies.begin(), bodies.end(), [&](const BodySurface& surface) {
          return surface.body == end->body;
        });
    if (body == bodies.end()) continue;
    std::vector<int> area = OnBones(
        *body, VerticesAt(end->voxels, grid, muscle.points), muscle.points);
    if (area.empty()) {
      const MuscleEnd& other =
          end == &ends.origin ? ends.insertion : ends.origin;
      area = VerticesAt(TipOf(*end, other, grid), grid, muscle.points);
      if (LiesOnSoftPart(area, muscle.points, soft_parts)) area.clear();
    }
    area = LargestConnected(area, muscle);
    if (area.empty()) continue;
    Attachment attachment;
    attachment.body = end->body;
    attachment.points = muscle.points(area, Eigen::all);
    attachment.radius = kPointsAlone;
    attachments.push_back(std::move(attachment));
  }
  return attachments;
}

}  // namespace musclewarp
