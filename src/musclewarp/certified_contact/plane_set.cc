// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/plane_set.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/geometry/half_space_projection.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

double LowestAbove(const SeparatingPlane& plane,
                   const std::vector<Points>& points) {
  double least = kInfinity;
  for (int k = 0; k < 3; ++k) {
    least = std::min(
        least,
        plane.normal.dot(points[plane.muscle_above].row(plane.above[k])));
  }
  return least;
}

double HighestBelow(const SeparatingPlane& plane,
                    const std::vector<Points>& points) {
  double most = -kInfinity;
  for (int k = 0; k < 3; ++k) {
    most = std::max(
        most, plane.normal.dot(points[plane.muscle_below].row(plane.below[k])));
  }
  return most;
}

}  // namespace

PlaneSet::PlaneSet(const StepOptions& options, const ContactStep& step)
    : options_(options),
      step_(step),
      sides_(step.scene.muscles.size()),
      first_sides_(step.scene.muscles.size()),
      near_(step.scene.muscles.size()),
      num_near_(step.scene.muscles.size()) {
  SortSides();
}

void PlaneSet::Add(const std::vector<SeparatingPlane>& planes) {
  if (planes.empty()) return;
  const ScopedStage stage("sorting planes");
  for (const SeparatingPlane& plane : planes) AddSides(plane);
  SortSides();
}

void PlaneSet::AddSides(const SeparatingPlane& plane) {
  const int a = plane.muscle_above, b = plane.muscle_below;
  if (plane.IsOfBone()) {
    const HalfSpace space = {plane.normal, plane.level};
    for (const int v : plane.above) {
      if (plane.normal.dot(step_.carried[a].row(v)) - plane.level <=
          options_.relaxation.max_push) {
        sides_[a].push_back({v, -1 - plane.bone, 1, space, plane.distance});
      }
    }
    return;
  }
  const int index = static_cast<int>(moving_.size());
  const double share_above =
      (1 + AttachedShare(a, plane.above) - AttachedShare(b, plane.below)) / 2;
  moving_.push_back({plane, share_above, 0});
  levels_.push_back(plane.level);
  for (int k = 0; k < 3; ++k) {
    sides_[a].push_back({plane.above[k],
                         index,
                         1,
                         {plane.normal, plane.half_gap},
                         plane.distance});
    sides_[b].push_back({plane.below[k],
                         index,
                         -1,
                         {-plane.normal, plane.half_gap},
                         plane.distance});
  }
}

double PlaneSet::AttachedShare(int muscle,
                               const Eigen::RowVector3i& corners) const {
  const std::vector<int>& attached = step_.attached[muscle].vertices;
  double count = 0;
  for (const int v : corners) {
    count += std::binary_search(attached.begin(), attached.end(), v);
  }
  return count / 3;
}

void PlaneSet::SortSides() {
#pragma omp parallel for schedule(dynamic, 1)
  for (int i = 0; i < step_.num_muscles(); ++i) {
    const int num_vertices = step_.scene.muscles[i].num_vertices();
    std::vector<int>& first = first_sides_[i];
    first.assign(num_vertices + 1, 0);
    for (const Side& side : sides_[i]) ++first[side.vertex + 1];
    for (size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    std::vector<Side> sorted(sides_[i].size());
    std::vector<int> next = first;
    for (const Side& side : sides_[i]) sorted[next[side.vertex]++] = side;
    // In an order that is not that of the muscles.
    const auto comes_first = [](const Side& a, const Side& b) {
      const auto key = [](const Side& side) {
        const RowVector3d& n = side.space.normal;
        return std::make_tuple(
            side.distance, side.space.level, n[0], n[1], n[2]);
      };
      return key(a) < key(b);
    };
    for (size_t v = 1; v < first.size(); ++v) {
      const auto begin = sorted.begin() + first[v - 1];
      const auto end = sorted.begin() + first[v];
      // Most have been sorted when planes were added before.
      if (std::is_sorted(begin, end, comes_first)) continue;
      std::stable_sort(begin, end, comes_first);
    }
    near_[i].resize(sorted.size());
    num_near_[i].assign(num_vertices, 0);
    sides_[i] = std::move(sorted);
  }
}

double PlaneSet::LevelOf(const Side& side) const {
  if (side.plane < 0) return side.space.level;
  return side.sign * levels_[side.plane] + side.space.level;
}

void PlaneSet::UpdateLevels(const std::vector<Points>& unprojected,
                            const std::vector<Points>& points,
                            bool is_first) {
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < moving_.size(); ++i) {
    UpdateLevel(unprojected, points, is_first, &moving_[i]);
    levels_[i] = moving_[i].plane.level;
  }
}

void PlaneSet::UpdateLevel(const std::vector<Points>& unprojected,
                           const std::vector<Points>& points,
                           bool is_first,
                           MovingPlane* moving) const {
  SeparatingPlane& plane = moving->plane;
  if (plane.shared_corner >= 0) {
    plane.level =
        plane.normal.dot(points[plane.muscle_above].row(plane.shared_corner));
    return;
  }
  if (!is_first) {
    const double down = std::max(
        0.0, plane.level + plane.half_gap - LowestAbove(plane, points));
    const double up = std::max(
        0.0, HighestBelow(plane, points) - plane.level + plane.half_gap);
    if (down + up < options_.relaxation.room_tolerance) {
      moving->shift *= options_.relaxation.room_decay;
    }
    moving->shift += up - down;
  }
  const double share = moving->share_above;
  plane.level =
      share * (LowestAbove(plane, unprojected) - plane.half_gap) +
      (1 - share) * (HighestBelow(plane, unprojected) + plane.half_gap) +
      moving->shift;
}

void PlaneSet::FindNear(int muscle, int vertex, const RowVector3d& point) {
  const int begin = first_sides_[muscle][vertex];
  int* near = near_[muscle].data() + begin;
  int count = 0;
  for (int i = begin; i < first_sides_[muscle][vertex + 1]; ++i) {
    const Side& side = sides_[muscle][i];
    if (side.space.normal.dot(point) < LevelOf(side) + options_.reach) {
      near[count++] = i;
    }
  }
  num_near_[muscle][vertex] = count;
}

RowVector3d PlaneSet::Projected(int muscle,
                                int vertex,
                                const RowVector3d& point) const {
  const int* near = near_[muscle].data() + first_sides_[muscle][vertex];
  const int count = num_near_[muscle][vertex];
  // Kept from call to call: most vertices have a few planes, some hundreds.
  thread_local std::vector<HalfSpace> spaces;
  if (static_cast<int>(spaces.size()) < count) spaces.resize(count);
  bool is_inside = true;
  for (int i = 0; i < count; ++i) {
    const Side& side = sides_[muscle][near[i]];
    spaces[i] = {side.space.normal, LevelOf(side)};
    is_inside &= spaces[i].normal.dot(point) >= spaces[i].level;
  }
  if (is_inside) return point;
  const RelaxationOptions& relaxation = options_.relaxation;
  RowVector3d nearest = point;
  if (!ProjectIntoHalfSpaces(
          spaces.data(), count, relaxation.max_push, &nearest)) {
    CompromiseBetweenHalfSpaces(
        spaces.data(), count, relaxation.violation_weight, &nearest);
    int bones = 0;
    for (int i = 0; i < count; ++i) {
      if (sides_[muscle][near[i]].plane < 0) spaces[bones++] = spaces[i];
    }
    ApproachHalfSpaces(spaces.data(), bones, relaxation.bone_turns, &nearest);
  }
  const RowVector3d carried = step_.carried[muscle].row(vertex);
  const RowVector3d push = nearest - carried;
  if (push.norm() <= relaxation.max_push) return nearest;
  return carried + relaxation.max_push / push.norm() * push;
}

PlaneCarrier PlaneSet::CarrierOf(const Side& side) const {
  PlaneCarrier carrier;
  if (side.plane < 0) {
    carrier.bone = -1 - side.plane;
    return carrier;
  }
  const MovingPlane& moving = moving_[side.plane];
  carrier.muscle_above = moving.plane.muscle_above;
  carrier.muscle_below = moving.plane.muscle_below;
  carrier.above = moving.plane.above;
  carrier.below = moving.plane.below;
  carrier.share_above = moving.share_above;
  return carrier;
}

CarriedHalfSpaces PlaneSet::MostViolated(int muscle,
                                         const std::vector<int>& vertices,
                                         const Points& points,
                                         const Points& targets) const {
  CarriedHalfSpaces most_violated;
  for (const int v : vertices) {
    double depth = -kInfinity;
    VertexHalfSpace deepest;
    const Side* side_of_deepest = nullptr;
    for (int i = first_sides_[muscle][v]; i < first_sides_[muscle][v + 1];
         ++i) {
      const Side& side = sides_[muscle][i];
      const RowVector3d& normal = side.space.normal;
      const double level = LevelOf(side);
      if (normal.dot(points.row(v)) >
          level + options_.relaxation.contact_distance) {
        continue;
      }
      const double depth_here = level - normal.dot(targets.row(v));
      if (depth_here <= depth) continue;
      depth = depth_here;
      deepest = {v, {normal, level}};
      side_of_deepest = &side;
    }
    if (!side_of_deepest) continue;
    most_violated.spaces.push_back(deepest);
    most_violated.carriers.push_back(CarrierOf(*side_of_deepest));
  }
  return most_violated;
}

double PlaneSet::WorstViolation(const std::vector<Points>& points) const {
  double worst = 0;
  for (int i = 0; i < step_.num_muscles(); ++i) {
    for (const Side& side : sides_[i]) {
      if (side.plane >= 0 && moving_[side.plane].plane.IsWithinOneMuscle()) {
        continue;
      }
      worst = std::max(
          worst,
          LevelOf(side) - side.space.normal.dot(points[i].row(side.vertex)));
    }
  }
  return worst;
}

}  // namespace musclewarp
