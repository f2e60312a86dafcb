// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/plane_set.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/work_counts.h"
#include "musclewarp/certified_contact/half_space_projection.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// The lowest level of the corners of a triangle above a plane through the
// origin, and the highest one, with further vertices.
double Lowest(const RowVector3d& normal,
              const Points& points,
              const Eigen::RowVector3i& corners) {
  double least = kInfinity;
  for (const int v : corners)
    least = std::min(least, normal.dot(points.row(v)));
  return least;
}

double Highest(const RowVector3d& normal,
               const Points& points,
               const Eigen::RowVector3i& corners,
               const std::vector<int>& further) {
  double most = -kInfinity;
  for (const int v : corners) most = std::max(most, normal.dot(points.row(v)));
  for (const int v : further) most = std::max(most, normal.dot(points.row(v)));
  return most;
}

}  // namespace

PlaneSet::PlaneSet(const StepOptions& options, const ContactStep& step)
    : options_(options),
      step_(step),
      spaces_(step.scene.muscles.size()),
      first_(step.scene.muscles.size()),
      near_(step.scene.muscles.size()),
      num_near_(step.scene.muscles.size()) {
  for (int i = 0; i < step.num_muscles(); ++i) {
    first_[i].assign(step.scene.muscles[i].num_vertices() + 1, 0);
  }
  SortSpaces(std::vector<std::vector<VertexSide>>(spaces_.size()));
}

void PlaneSet::Add(const std::vector<SeparatingPlane>& planes) {
  if (planes.empty()) return;
  const ScopedStage stage("sorting planes");
  std::vector<std::vector<VertexSide>> added(spaces_.size());
  for (const SeparatingPlane& plane : planes) {
    const Side above = static_cast<Side>(planes_.size());
    const int a = plane.muscle_above, b = plane.muscle_below;
    AddPlane(plane);
    for (const int v : plane.above) {
      const bool is_beyond =
          plane.IsOfBone() &&
          plane.normal.dot(step_.predicted[a].row(v)) - plane.level >
              options_.relaxation.max_push;
      if (!is_beyond) added[a].push_back({v, above});
    }
    if (plane.IsOfBone()) continue;
    for (const int v : plane.below) added[b].push_back({v, ~above});
    for (const int v : plane.also_below) added[b].push_back({v, ~above});
  }
  CountWork(WorkUnit::kPlanes, static_cast<std::int64_t>(planes.size()));
  for (const std::vector<VertexSide>& sides : added) {
    CountWork(WorkUnit::kHalfSpaces, static_cast<std::int64_t>(sides.size()));
  }
  SortSpaces(added);
}

void PlaneSet::AddPlane(const SeparatingPlane& plane) {
  const int number = static_cast<int>(planes_.size());
  if (plane.IsOfBone()) {
    planes_.push_back({plane.normal, 0, plane.distance, -1 - plane.bone});
    levels_.emplace_back();
    SetLevel(number, plane.level);
    return;
  }
  planes_.push_back({plane.normal,
                     plane.half_gap,
                     plane.distance,
                     static_cast<int>(moving_.size())});
  levels_.emplace_back();
  SetLevel(number, plane.level);
  MovingPlane moving;
  moving.plane = number;
  moving.shared_corner = plane.shared_corner;
  moving.also_below = plane.also_below;
  PlaneOwner& owner = moving.owner;
  owner.muscle_above = plane.muscle_above;
  owner.muscle_below = plane.muscle_below;
  owner.above = plane.above;
  owner.below = plane.below;
  owner.share_above = (1 + AttachedShare(plane.muscle_above, plane.above) -
                       AttachedShare(plane.muscle_below, plane.below)) /
                      2;
  moving.share_above = step_.is_still[plane.muscle_above]   ? 1
                       : step_.is_still[plane.muscle_below] ? 0
                                                            : owner.share_above;
  moving_.push_back(moving);
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

PlaneSet::VertexSpace PlaneSet::SpaceOf(Side side) const {
  const Plane& plane = planes_[NumberOf(side)];
  return {side < 0 ? RowVector3d(-plane.normal) : plane.normal,
          LevelOf(side),
          plane.distance,
          side,
          plane.moving < 0};
}

bool PlaneSet::ComesBefore(const VertexSpace& a, const VertexSpace& b) const {
  if (a.distance != b.distance) return a.distance < b.distance;
  // The order must not depend on that of the muscles. Planes between muscles
  // are compared by their gaps, as their levels still change.
  const auto key = [&](const VertexSpace& space) {
    const RowVector3d& n = space.normal;
    return std::make_tuple(space.is_of_bone
                               ? LevelOf(space.side)
                               : planes_[NumberOf(space.side)].half_gap,
                           n[0],
                           n[1],
                           n[2]);
  };
  return key(a) < key(b);
}

void PlaneSet::SortSpaces(const std::vector<std::vector<VertexSide>>& added) {
#pragma omp parallel for schedule(dynamic, 1)
  for (int i = 0; i < step_.num_muscles(); ++i) {
    const int num_vertices = step_.scene.muscles[i].num_vertices();
    const std::vector<int>& before = first_[i];
    std::vector<int> first(num_vertices + 1, 0);
    for (const VertexSide& side : added[i]) ++first[side.vertex + 1];
    for (int v = 0; v < num_vertices; ++v) {
      first[v + 1] += first[v] + before[v + 1] - before[v];
    }
    std::vector<VertexSpace> sorted(first.back());
    std::vector<int> next = first;
    for (int v = 0; v < num_vertices; ++v) {
      next[v] = static_cast<int>(std::copy(spaces_[i].begin() + before[v],
                                           spaces_[i].begin() + before[v + 1],
                                           sorted.begin() + first[v]) -
                                 sorted.begin());
    }
    for (const VertexSide& side : added[i]) {
      sorted[next[side.vertex]++] = SpaceOf(side.side);
    }
    const auto comes_before = [&](const VertexSpace& a, const VertexSpace& b) {
      return ComesBefore(a, b);
    };
    for (int v = 0; v < num_vertices; ++v) {
      const auto begin = sorted.begin() + first[v];
      const auto end = sorted.begin() + first[v + 1];
      // Most are already sorted from earlier calls of Add().
      if (std::is_sorted(begin, end, comes_before)) continue;
      std::stable_sort(begin, end, comes_before);
    }
    near_[i].resize(sorted.size());
    num_near_[i].assign(num_vertices, 0);
    spaces_[i] = std::move(sorted);
    first_[i] = std::move(first);
  }
}

void PlaneSet::SetLevel(int plane, double level) {
  const double half_gap = planes_[plane].half_gap;
  levels_[plane] = {level + half_gap, half_gap - level};
}

void PlaneSet::UpdateLevels(const std::vector<Points>& unprojected,
                            const std::vector<Points>& points,
                            bool is_first) {
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < moving_.size(); ++i) {
    UpdateLevel(unprojected, points, is_first, &moving_[i]);
  }
}

void PlaneSet::UpdateLevel(const std::vector<Points>& unprojected,
                           const std::vector<Points>& points,
                           bool is_first,
                           MovingPlane* moving) {
  const auto& [normal, half_gap, distance, index] = planes_[moving->plane];
  const PlaneOwner& owner = moving->owner;
  const int a = owner.muscle_above, b = owner.muscle_below;
  if (moving->shared_corner >= 0) {
    SetLevel(moving->plane, normal.dot(points[a].row(moving->shared_corner)));
    return;
  }
  if (!is_first) {
    const auto& [above, below] = levels_[moving->plane];
    const double down =
        std::max(0.0, above - Lowest(normal, points[a], owner.above));
    const double up = std::max(
        0.0,
        Highest(normal, points[b], owner.below, moving->also_below) + below);
    if (down + up < options_.relaxation.room_tolerance) {
      moving->shift *= options_.relaxation.room_decay;
    }
    moving->shift += up - down;
  }
  const double share = moving->share_above;
  SetLevel(
      moving->plane,
      share * (Lowest(normal, unprojected[a], owner.above) - half_gap) +
          (1 - share) *
              (Highest(
                   normal, unprojected[b], owner.below, moving->also_below) +
               half_gap) +
          moving->shift);
}

void PlaneSet::FindNear(int muscle, int vertex, const RowVector3d& point) {
  // The cosine of 4 degrees. While a vertex moves by a millimetre, what such
  // planes differ by stays below 0.07 mm.
  constexpr double kSameWay = 0.998;
  const int begin = first_[muscle][vertex], end = first_[muscle][vertex + 1];
  const double reach = ReachOf(options_, step_, muscle);
  VertexSpace* spaces = spaces_[muscle].data();
  int* near = near_[muscle].data() + begin;
  // Reused between calls: the room that each near half-space leaves, mm.
  thread_local std::vector<double> rooms;
  rooms.resize(std::max<size_t>(rooms.size(), end - begin));
  int count = 0;
  for (int i = begin; i < end; ++i) {
    VertexSpace& space = spaces[i];
    space.level = LevelOf(space.side);
    const double room = space.normal.dot(point) - space.level;
    if (room >= reach) continue;
    const auto face_alike = [&](const VertexSpace& other) {
      return other.is_of_bone == space.is_of_bone &&
             other.normal.dot(space.normal) >= kSameWay;
    };
    int k = 0;
    while (k < count && !face_alike(spaces[near[k]])) ++k;
    if (k < count && rooms[k] <= room) continue;
    near[k] = i;
    rooms[k] = room;
    count = std::max(count, k + 1);
  }
  num_near_[muscle][vertex] = count;
}

void PlaneSet::RefreshNear(int muscle, int vertex) {
  VertexSpace* spaces = spaces_[muscle].data();
  const int* near = near_[muscle].data() + first_[muscle][vertex];
  const int count = num_near_[muscle][vertex];
  for (int i = 0; i < count; ++i) {
    spaces[near[i]].level = LevelOf(spaces[near[i]].side);
  }
}

RowVector3d PlaneSet::Projected(int muscle,
                                int vertex,
                                const RowVector3d& point) const {
  const VertexSpace* all = spaces_[muscle].data();
  const int* near = near_[muscle].data() + first_[muscle][vertex];
  const int count = num_near_[muscle][vertex];
  const bool is_inside = std::all_of(near, near + count, [&](int i) {
    return all[i].normal.dot(point) >= all[i].level;
  });
  if (is_inside) return point;
  // Reused between calls: most vertices have a few planes, some hundreds.
  thread_local std::vector<HalfSpace> spaces;
  if (static_cast<int>(spaces.size()) < count) spaces.resize(count);
  for (int i = 0; i < count; ++i) {
    spaces[i] = {all[near[i]].normal, all[near[i]].level};
  }
  const RelaxationOptions& relaxation = options_.relaxation;
  RowVector3d nearest = point;
  if (!ProjectIntoHalfSpaces(
          spaces.data(), count, relaxation.max_push, &nearest)) {
    CompromiseBetweenHalfSpaces(
        spaces.data(), count, relaxation.violation_weight, &nearest);
    int bones = 0;
    for (int i = 0; i < count; ++i) {
      if (all[near[i]].is_of_bone) spaces[bones++] = spaces[i];
    }
    ApproachHalfSpaces(spaces.data(), bones, relaxation.bone_turns, &nearest);
  }
  const RowVector3d predicted = step_.predicted[muscle].row(vertex);
  const RowVector3d push = nearest - predicted;
  if (push.norm() <= relaxation.max_push) return nearest;
  return predicted + relaxation.max_push / push.norm() * push;
}

bool PlaneSet::IsWithinOneMuscle(Side side) const {
  const int moving = planes_[NumberOf(side)].moving;
  if (moving < 0) return false;
  const PlaneOwner& owner = moving_[moving].owner;
  return owner.muscle_above == owner.muscle_below;
}

PlaneOwner PlaneSet::CarrierOf(Side side) const {
  const int moving = planes_[NumberOf(side)].moving;
  if (moving >= 0) return moving_[moving].owner;
  PlaneOwner owner;
  owner.bone = -1 - moving;
  return owner;
}

OwnedHalfSpaces PlaneSet::MostViolated(int muscle,
                                       const std::vector<int>& vertices,
                                       const Points& points,
                                       const Points& targets) const {
  OwnedHalfSpaces most_violated;
  const std::vector<int>& first = first_[muscle];
  for (const int v : vertices) {
    double depth = -kInfinity;
    VertexHalfSpace deepest;
    const VertexSpace* deepest_space = nullptr;
    for (int i = first[v]; i < first[v + 1]; ++i) {
      const VertexSpace& of_vertex = spaces_[muscle][i];
      const HalfSpace space = {of_vertex.normal, LevelOf(of_vertex.side)};
      if (space.normal.dot(points.row(v)) >
          space.level + options_.relaxation.contact_distance) {
        continue;
      }
      const double depth_here = space.level - space.normal.dot(targets.row(v));
      if (depth_here <= depth) continue;
      depth = depth_here;
      deepest = {v, space};
      deepest_space = &of_vertex;
    }
    if (!deepest_space) continue;
    most_violated.spaces.push_back(deepest);
    most_violated.owners.push_back(CarrierOf(deepest_space->side));
  }
  return most_violated;
}

double PlaneSet::WorstViolation(const std::vector<Points>& points) const {
  double worst = 0;
  for (int i = 0; i < step_.num_muscles(); ++i) {
    const std::vector<int>& first = first_[i];
    for (Eigen::Index v = 0; v < points[i].rows(); ++v) {
      for (int k = first[v]; k < first[v + 1]; ++k) {
        const VertexSpace& space = spaces_[i][k];
        const double violation =
            LevelOf(space.side) - space.normal.dot(points[i].row(v));
        if (violation <= worst || IsWithinOneMuscle(space.side)) continue;
        worst = violation;
      }
    }
  }
  return worst;
}

}  // namespace musclewarp
