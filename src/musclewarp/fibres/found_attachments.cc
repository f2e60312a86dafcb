// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/found_attachments.h"

#include <algorithm>
#include <map>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/fibres/attachment_outline.h"
#include "musclewarp/fibres/distance_outside.h"
#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/mesh/connectivity.h"

namespace musclewarp {
namespace {

// The number of voxels on which ends are found, as for fibres.
constexpr int kVoxels = 6000;
// The length of the attached part at an end without a bone, as a share of the
// length of the muscle.
constexpr double kTipShare = 0.1;
// Returns the vertices whose nearest voxel is one of `voxels` (ascending).
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

// Returns the largest subset of `vertices` that is connected by edges, in
// ascending order.
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

// Returns the vertices that lie on or inside the bones of a body. Empty if no
// bone is near.
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

// Returns the voxel of an end that is farthest from the other end.
int TipOf(const MuscleEnd& end, const MuscleEnd& other, const VoxelGrid& grid) {
  const Eigen::VectorXd from_other = DistancesWithin(grid, other.voxels);
  return *std::max_element(
      end.voxels.begin(), end.voxels.end(), [&](int a, int b) {
        return from_other[a] < from_other[b];
      });
}

// Returns the voxels around a tip.
std::vector<int> VoxelsAround(int tip, const VoxelGrid& grid) {
  const Eigen::VectorXd from_tip = DistancesWithin(grid, {tip});
  std::vector<int> voxels;
  for (int v = 0; v < grid.num_voxels(); ++v) {
    if (from_tip[v] <= kTipShare * from_tip.maxCoeff()) voxels.push_back(v);
  }
  return voxels;
}

}  // namespace

std::vector<FoundAttachment> FindAttachments(
    const TriangleSoup& muscle,
    const std::vector<BodySurface>& bodies,
    const std::vector<ActionLine>& lines,
    EndExtent extent) {
  const VoxelGrid grid = Voxelize(muscle, kVoxels);
  std::vector<FoundAttachment> found;
  if (bodies.empty() || grid.num_voxels() < 2) return found;
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
    const bool is_on_bones = !area.empty();
    Eigen::RowVector3d tip = Eigen::RowVector3d::Zero();
    if (!is_on_bones) {
      const int voxel =
          TipOf(*end, end == &ends.origin ? ends.insertion : ends.origin, grid);
      tip = grid.Center(voxel);
      area = VerticesAt(VoxelsAround(voxel, grid), grid, muscle.points);
    }
    area = LargestConnected(area, muscle);
    if (area.empty()) continue;
    Attachment attachment;
    attachment.body = end->body;
    attachment.points = muscle.points(area, Eigen::all);
    attachment.radius = kPointsAlone;
    found.push_back({std::move(attachment), is_on_bones, tip});
  }
  return found;
}

}  // namespace musclewarp
