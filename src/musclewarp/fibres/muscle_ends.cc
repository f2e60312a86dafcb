// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/muscle_ends.h"

#include <glog/logging.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "musclewarp/scene/attachment_area.h"

namespace musclewarp {
namespace {

// If a tip of the muscle is farther from all areas than this share of the
// muscle's length, its bone is missing.
constexpr double kLoneEnd = 0.3;
// The corresponding share if a line of the muscle also ends at the tip, which
// indicates that no area in between is the end of the muscle.
constexpr double kLoneLineEnd = 0.1;
// Only the part of an area is kept whose distance from the other area is at
// least this share of the largest such distance; likewise for a lone tip.
constexpr double kEndShare = 0.7;

// The part of an area that is farther from the bones of the other end than this
// share of the muscle's length belongs to the end too, for origins that run
// along a muscle.
constexpr double kClearShare = 0.2;

void SortUnique(std::vector<int>* voxels) {
  std::sort(voxels->begin(), voxels->end());
  voxels->erase(std::unique(voxels->begin(), voxels->end()), voxels->end());
}

Points RowsOf(const Points& points, const std::vector<int>& rows) {
  Points chosen(rows.size(), 3);
  for (size_t i = 0; i < rows.size(); ++i) chosen.row(i) = points.row(rows[i]);
  return chosen;
}

// Returns the voxels nearest to points of the surface, ascending.
std::vector<int> VoxelsAt(const VoxelGrid& grid, const Points& points) {
  std::vector<int> voxels;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const int voxel = grid.Nearest(points.row(i));
    if (voxel >= 0) voxels.push_back(voxel);
  }
  SortUnique(&voxels);
  return voxels;
}

double Median(const Eigen::VectorXd& values, const std::vector<int>& at) {
  std::vector<double> chosen;
  for (const int i : at) chosen.push_back(values[i]);
  const auto middle = chosen.begin() + chosen.size() / 2;
  std::nth_element(chosen.begin(), middle, chosen.end());
  return *middle;
}

// Returns those of `voxels` whose distance is at least kEndShare of the
// largest.
std::vector<int> FarPart(const Eigen::VectorXd& distances,
                         const std::vector<int>& voxels) {
  double farthest = 0;
  for (const int v : voxels) farthest = std::max(farthest, distances[v]);
  std::vector<int> far;
  for (const int v : voxels) {
    if (distances[v] >= kEndShare * farthest) far.push_back(v);
  }
  return far;
}

// Returns the surface of a body, or null if it has none.
const BodySurface* SurfaceNamed(const std::vector<BodySurface>& bodies,
                                const std::string& name) {
  for (const BodySurface& body : bodies) {
    if (body.body == name) return &body;
  }
  return nullptr;
}

// Returns the voxels of an area that are far from the other end of the muscle
// (FarPart), or farther than `clear` (mm) from the bones of the other body.
std::vector<int> FarOrClearPart(const VoxelGrid& grid,
                                const Eigen::VectorXd& distances,
                                const BodySurface* other,
                                double clear,
                                const std::vector<int>& voxels) {
  std::vector<int> chosen = FarPart(distances, voxels);
  for (const int v : voxels) {
    if (other && other->Distance(grid.Center(v)) > clear) chosen.push_back(v);
  }
  SortUnique(&chosen);
  return chosen;
}

std::string NearestBody(const std::vector<BodySurface>& bodies,
                        const Eigen::RowVector3d& point) {
  std::string nearest;
  double distance = std::numeric_limits<double>::infinity();
  for (const BodySurface& body : bodies) {
    const double here = body.Distance(point);
    if (here < distance) {
      distance = here;
      nearest = body.body;
    }
  }
  return nearest;
}

// Returns the areas of the attachments: one for each body, if there are several
// bodies, else one for each attachment.
std::vector<MuscleEnd> GivenAreas(const TriangleSoup& muscle,
                                  const VoxelGrid& grid,
                                  const std::vector<Attachment>& attachments) {
  const bool several_bodies = std::any_of(
      attachments.begin(), attachments.end(), [&](const Attachment& other) {
        return other.body != attachments[0].body;
      });
  std::vector<MuscleEnd> areas;
  for (const Attachment& attachment : attachments) {
    const std::vector<int> vertices = VerticesInArea(attachment, muscle.points);
    // If no vertex is in the area, its own points are used.
    Points points = attachment.points;
    if (!vertices.empty()) points = RowsOf(muscle.points, vertices);
    std::vector<int> voxels = VoxelsAt(grid, points);
    if (voxels.empty()) continue;
    const auto same =
        std::find_if(areas.begin(), areas.end(), [&](const MuscleEnd& area) {
          return several_bodies && area.body == attachment.body;
        });
    if (same == areas.end()) {
      areas.push_back({attachment.body, std::move(voxels)});
      continue;
    }
    same->voxels.insert(same->voxels.end(), voxels.begin(), voxels.end());
    SortUnique(&same->voxels);
  }
  return areas;
}

// Returns the areas in which the surface lies near bones, one for each body.
std::vector<MuscleEnd> NearAreas(const TriangleSoup& muscle,
                                 const VoxelGrid& grid,
                                 const std::vector<BodySurface>& bodies) {
  std::vector<MuscleEnd> areas;
  const auto near = VerticesNearBones(muscle.points, bodies);
  for (size_t b = 0; b < bodies.size(); ++b) {
    MuscleEnd area{bodies[b].body,
                   VoxelsAt(grid, RowsOf(muscle.points, near[b]))};
    if (!area.voxels.empty()) areas.push_back(std::move(area));
  }
  return areas;
}

// Returns the two tips of the muscle: the voxel farthest from an arbitrary one,
// and the voxel farthest from that.
std::pair<int, int> Tips(const VoxelGrid& grid) {
  Eigen::Index first, second;
  DistancesWithin(grid, {0}).maxCoeff(&first);
  DistancesWithin(grid, {static_cast<int>(first)}).maxCoeff(&second);
  return {static_cast<int>(first), static_cast<int>(second)};
}

// Returns the body of a line that ends within `distance` of a tip, measured by
// `from_tip` (one distance per voxel), or nothing.
std::optional<std::string> BodyOfLineAt(const VoxelGrid& grid,
                                        const std::vector<ActionLine>& lines,
                                        const Eigen::VectorXd& from_tip,
                                        double distance) {
  for (const ActionLine& line : lines) {
    if (line.bodies.empty()) continue;  // its poses give target points
    for (const Eigen::Index end : {Eigen::Index{0}, line.rest.rows() - 1}) {
      const int voxel = grid.Nearest(line.rest.row(end));
      if (voxel >= 0 && from_tip[voxel] <= distance) return line.bodies[end];
    }
  }
  return std::nullopt;
}

// Adds each tip of the muscle that is far from all areas as an area.
void AddLoneEnds(const VoxelGrid& grid,
                 const std::vector<BodySurface>& bodies,
                 const std::vector<ActionLine>& lines,
                 std::vector<MuscleEnd>* areas) {
  const auto [first, second] = Tips(grid);
  const double length = DistancesWithin(grid, {first})[second];
  std::vector<int> all;
  for (const MuscleEnd& area : *areas) {
    all.insert(all.end(), area.voxels.begin(), area.voxels.end());
  }
  const auto add = [&](int tip, const Eigen::VectorXd& distances) {
    const Eigen::VectorXd from_tip = DistancesWithin(grid, {tip});
    const double distance = distances[tip];
    std::vector<int> voxels;
    for (int v = 0; v < grid.num_voxels(); ++v) {
      if (distances[v] >= kEndShare * distance &&
          from_tip[v] <= (1 - kEndShare) * distance) {
        voxels.push_back(v);
      }
    }
    const auto body =
        BodyOfLineAt(grid, lines, from_tip, kLoneLineEnd * length);
    areas->push_back({body ? *body : NearestBody(bodies, grid.Center(tip)),
                      std::move(voxels)});
  };
  // Without any area, both tips are added.
  if (all.empty()) {
    add(first, DistancesWithin(grid, {second}));
    add(second, DistancesWithin(grid, {first}));
    return;
  }
  const Eigen::VectorXd distances = DistancesWithin(grid, all);
  for (const int tip : {first, second}) {
    if (distances[tip] > kLoneLineEnd * length &&
        distances[tip] <= kLoneEnd * length &&
        BodyOfLineAt(
            grid, lines, DistancesWithin(grid, {tip}), kLoneLineEnd * length)) {
      add(tip, distances);
    }
  }
  Eigen::Index farthest;
  if (distances.maxCoeff(&farthest) > kLoneEnd * length || areas->size() == 1) {
    add(static_cast<int>(farthest), distances);
  }
}

}  // namespace

double BodySurface::Distance(const Eigen::RowVector3d& point) const {
  double distance = std::numeric_limits<double>::infinity();
  for (const TriangleBvh* bone : bones) {
    distance = std::min(distance, bone->ClosestPoint(point, distance).distance);
  }
  return distance;
}

namespace {

// Returns the two areas that are farthest apart. `distances` has the distances
// of all voxels from each area.
std::pair<size_t, size_t> FarthestApart(
    const std::vector<MuscleEnd>& areas,
    const std::vector<Eigen::VectorXd>& distances) {
  std::pair<size_t, size_t> farthest = {0, 1};
  double most = -1;
  for (size_t i = 0; i < areas.size(); ++i) {
    for (size_t j = i + 1; j < areas.size(); ++j) {
      const double apart = Median(distances[i], areas[j].voxels) +
                           Median(distances[j], areas[i].voxels);
      if (apart <= most) continue;
      most = apart;
      farthest = {i, j};
    }
  }
  return farthest;
}

// Removes voxels that both ends share, as areas of two bodies may.
void DropSharedVoxels(MuscleEnds* ends) {
  std::vector<int> shared;
  std::set_intersection(ends->origin.voxels.begin(),
                        ends->origin.voxels.end(),
                        ends->insertion.voxels.begin(),
                        ends->insertion.voxels.end(),
                        std::back_inserter(shared));
  for (MuscleEnd* end : {&ends->origin, &ends->insertion}) {
    std::vector<int> own;
    std::set_difference(end->voxels.begin(),
                        end->voxels.end(),
                        shared.begin(),
                        shared.end(),
                        std::back_inserter(own));
    end->voxels = std::move(own);
  }
}

}  // namespace

std::vector<std::vector<int>> VerticesNearBones(
    const Points& points, const std::vector<BodySurface>& bodies) {
  const Eigen::Index count = points.rows();
  Eigen::MatrixXd distances(count, bodies.size());
#pragma omp parallel for schedule(dynamic, 64)
  for (Eigen::Index v = 0; v < count; ++v) {
    for (size_t b = 0; b < bodies.size(); ++b) {
      double distance = kNearBone + kAreaDepth;
      for (const TriangleBvh* bone : bodies[b].bones) {
        distance = std::min(
            distance, bone->ClosestPoint(points.row(v), distance).distance);
      }
      distances(v, b) = distance;
    }
  }
  std::vector<std::vector<int>> near(bodies.size());
  for (size_t b = 0; count > 0 && b < bodies.size(); ++b) {
    const double nearest = distances.col(b).minCoeff();
    if (nearest > kNearBone) continue;
    for (Eigen::Index v = 0; v < count; ++v) {
      if (distances(v, b) <= nearest + kAreaDepth &&
          distances(v, b) == distances.row(v).minCoeff()) {
        near[b].push_back(static_cast<int>(v));
      }
    }
  }
  return near;
}

MuscleEnds FindMuscleEnds(const TriangleSoup& muscle,
                          const VoxelGrid& grid,
                          const std::vector<BodySurface>& bodies,
                          const KnownEnds& known,
                          EndExtent extent) {
  std::vector<MuscleEnd> areas = GivenAreas(muscle, grid, known.attachments);
  const bool is_given = areas.size() >= 2;
  if (areas.empty()) areas = NearAreas(muscle, grid, bodies);
  if (areas.size() < 2 || known.attachments.empty()) {
    AddLoneEnds(grid, bodies, known.lines, &areas);
  }
  std::vector<Eigen::VectorXd> distances;
  for (const MuscleEnd& area : areas) {
    distances.push_back(DistancesWithin(grid, area.voxels));
  }
  const auto [a, b] = FarthestApart(areas, distances);
  MuscleEnds ends;
  ends.origin.body = areas[a].body;
  ends.insertion.body = areas[b].body;
  if (is_given) {
    ends.origin.voxels = areas[a].voxels;
    ends.insertion.voxels = areas[b].voxels;
  } else {
    const double clear = extent == EndExtent::kClearOfOther
                             ? kClearShare * distances[b].maxCoeff()
                             : std::numeric_limits<double>::infinity();
    ends.origin.voxels = FarOrClearPart(grid,
                                        distances[b],
                                        SurfaceNamed(bodies, areas[b].body),
                                        clear,
                                        areas[a].voxels);
    ends.insertion.voxels =
        FarOrClearPart(grid,
                       DistancesWithin(grid, ends.origin.voxels),
                       SurfaceNamed(bodies, areas[a].body),
                       clear,
                       areas[b].voxels);
  }
  DropSharedVoxels(&ends);
  // If no two ends remain, for example because the areas are the same place,
  // the tips of the muscle are the ends.
  if (ends.origin.voxels.empty() || ends.insertion.voxels.empty()) {
    const auto [first, second] = Tips(grid);
    ends.origin.voxels = {first};
    ends.insertion.voxels = {second};
  }
  // The order of bodies in the scene decides which end is the origin.
  const auto rank = [&](const std::string& body) {
    size_t i = 0;
    while (i < bodies.size() && bodies[i].body != body) ++i;
    return i;
  };
  if (rank(ends.insertion.body) < rank(ends.origin.body)) {
    std::swap(ends.origin, ends.insertion);
  }
  return ends;
}

}  // namespace musclewarp
