// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/separating_planes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/work_counts.h"
#include "musclewarp/proximity/triangle_distance.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Pairs grouped by their first index.
struct Grouped {
  std::vector<int> starts, items;

  const int* begin(Eigen::Index first) const {
    return items.data() + starts[first];
  }
  int count(Eigen::Index first) const {
    return starts[first + 1] - starts[first];
  }
  std::int64_t size() const { return static_cast<std::int64_t>(items.size()); }
};

Grouped ByFirst(const std::vector<std::pair<int, int>>& pairs,
                Eigen::Index count) {
  Grouped grouped;
  grouped.starts.assign(count + 1, 0);
  for (const auto& pair : pairs) ++grouped.starts[pair.first + 1];
  for (Eigen::Index i = 0; i < count; ++i) {
    grouped.starts[i + 1] += grouped.starts[i];
  }
  std::vector<int> next = grouped.starts;
  grouped.items.resize(pairs.size());
  for (const auto& [first, second] : pairs) {
    grouped.items[next[first]++] = second;
  }
  return grouped;
}

void Append(const std::vector<std::vector<SeparatingPlane>>& parts,
            std::vector<SeparatingPlane>* planes) {
  for (const auto& part : parts) {
    planes->insert(planes->end(), part.begin(), part.end());
  }
}

// What is known of a muscle.
struct MuscleData {
  double radius = 0;  // its part of the search radius, mm

  // By node of its tree: boxes around its triangles, larger by that part on all
  // sides, before the step and at the prediction.
  std::vector<Box3> before, predicted;

  // By triangle: how many of its corners are attached.
  std::vector<int> attached_corners;
};

std::vector<MuscleData> MuscleDataOf(
    const StepOptions& options,
    const ContactStep& step,
    const std::vector<TriangleBvh>& predicted) {
  std::vector<MuscleData> data(predicted.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (size_t i = 0; i < predicted.size(); ++i) {
    const MuscleSurface& surface = step.scene.muscles[i];
    std::vector<char> is_attached(surface.num_vertices(), false);
    for (const int v : step.attached[i].vertices) is_attached[v] = true;
    const double radius = options.AimedGap() / 2 +
                          options.planes.search_fraction *
                              ReachOf(options, step, static_cast<int>(i));
    data[i].radius = radius;
    const int count = predicted[i].num_triangles();
    std::vector<Box3> before(count), after(count);
    data[i].attached_corners.resize(count);
    for (int f = 0; f < count; ++f) {
      before[f] = BoxOf(step.trees_before[i].corners(f), radius);
      after[f] = BoxOf(predicted[i].corners(f), radius);
      for (const int v : surface.triangles.row(f)) {
        data[i].attached_corners[f] += is_attached[v];
      }
    }
    data[i].before = predicted[i].BoxesOfNodes(before);
    data[i].predicted = predicted[i].BoxesOfNodes(after);
  }
  return data;
}

// The muscles for AddPlanesBetweenMuscles().
struct NearMuscles {
  const std::vector<TriangleBvh>& predicted;
  const std::vector<MuscleData>& muscles;

  // The search radius of two muscles, mm: both may move by their reach.
  double RadiusOf(int a, int b) const {
    return muscles[a].radius + muscles[b].radius;
  }
};

// The planes of one triangle of a muscle against another muscle.
class TrianglePlanes {
 public:
  TrianglePlanes(const StepOptions& options,
                 const ContactStep& step,
                 const NearMuscles& near,
                 int a,
                 int b,
                 int f)
      : options_(options),
        step_(step),
        a_(a),
        b_(b),
        f_(f),
        square_(std::pow(near.RadiusOf(a, b), 2)),
        before_(step.trees_before[a].corners(f)),
        predicted_(near.predicted[a].corners(f)),
        others_before_(step.trees_before[b]),
        others_predicted_(near.predicted[b]),
        attached_corners_(near.muscles[b].attached_corners) {}

  // Finds planes to the `count` triangles `others` of the other muscle, as far
  // as they are within the radius.
  std::vector<SeparatingPlane> To(const int* others, int count) {
    std::vector<SeparatingPlane> planes;
    SetOpen(others, count);
    for (size_t next = 0; next < open_.size(); ++next) {
      const int g = open_[next].triangle;
      const auto separation =
          SeparateTriangles(before_, others_before_.corners(g));
      if (!separation) continue;
      if (separation->distance * separation->distance > square_ &&
          ClosestPointsOfTriangles(predicted_, others_predicted_.corners(g))
                  .squared_distance > square_) {
        continue;
      }
      SeparatingPlane& plane = planes.emplace_back(PlaneBetween(
          step_, a_, f_, b_, g, *separation, options_.AimedGap() / 2));
      TakeThoseBehind(g, *separation, next + 1, &plane);
    }
    return planes;
  }

 private:
  struct Open {
    double square;  // of the distance of the centres, mm^2
    int triangle;

    bool operator<(const Open& other) const {
      return std::tie(square, triangle) <
             std::tie(other.square, other.triangle);
    }
  };

  // Sets the triangles that may be within the radius, the nearest first.
  void SetOpen(const int* others, int count) {
    open_.clear();
    const RowVector3d centre = before_.colwise().sum();
    for (const int* g = others; g < others + count; ++g) {
      const Corners corners = others_before_.corners(*g);
      if (AreSurelyFarther(before_, corners, square_) &&
          AreSurelyFarther(
              predicted_, others_predicted_.corners(*g), square_)) {
        continue;
      }
      const double square =
          (corners.colwise().sum() - centre).squaredNorm() / 9;
      open_.push_back({square, *g});
    }
    std::sort(open_.begin(), open_.end());
  }

  // Adds to the plane in front of triangle `g` the open triangles from `first`
  // on that are behind it, and yield as much as it does: attached ones do not
  // (PlaneSet). A part of what the distance exceeds the gap by is left to
  // surfaces that bend.
  void TakeThoseBehind(int g,
                       const TriangleSeparation& separation,
                       size_t first,
                       SeparatingPlane* plane) {
    const double gap = options_.AimedGap();
    const double room = std::max(0.0, separation.distance - gap) / 2 +
                        options_.planes.overlooked_fraction * gap;
    const auto highest = [&](int triangle) {
      return (others_before_.corners(triangle) * separation.normal.transpose())
          .maxCoeff();
    };
    const double limit = highest(g) + room;
    const auto is_behind = [&](const Open& open) {
      if (attached_corners_[open.triangle] != attached_corners_[g] ||
          highest(open.triangle) > limit) {
        return false;
      }
      for (const int v : step_.scene.muscles[b_].triangles.row(open.triangle)) {
        plane->also_below.push_back(v);
      }
      return true;
    };
    open_.erase(std::remove_if(open_.begin() + first, open_.end(), is_behind),
                open_.end());
    std::vector<int>& also = plane->also_below;
    std::sort(also.begin(), also.end());
    also.erase(std::unique(also.begin(), also.end()), also.end());
    const Eigen::RowVector3i& below = plane->below;
    also.erase(
        std::remove_if(also.begin(),
                       also.end(),
                       [&](int v) { return (below.array() == v).any(); }),
        also.end());
  }

  const StepOptions& options_;
  const ContactStep& step_;
  const int a_, b_, f_;
  const double square_;  // of the radius
  const Corners before_, predicted_;
  const TriangleBvh &others_before_, &others_predicted_;
  const std::vector<int>& attached_corners_;  // of the others
  std::vector<Open> open_;
};

// Adds the planes of the triangles of `a` against muscle `b`.
void AddPlanesBetweenMuscles(const StepOptions& options,
                             const ContactStep& step,
                             const NearMuscles& near,
                             int a,
                             int b,
                             std::vector<SeparatingPlane>* planes) {
  const MuscleData &of_a = near.muscles[a], &of_b = near.muscles[b];
  // Muscles that move together stay near each other: boxes around their whole
  // motion would overlap far more often.
  const auto may_be_near = [&](int node_a, int node_b) {
    return of_a.before[node_a].Overlaps(of_b.before[node_b]) ||
           of_a.predicted[node_a].Overlaps(of_b.predicted[node_b]);
  };
  const double square = std::pow(near.RadiusOf(a, b), 2);
  const auto are_near = [&](int f, int g) {
    const auto are_near_in = [&](const TriangleBvh& tree_a,
                                 const TriangleBvh& tree_b) {
      return BoxOf(tree_a.corners(f))
                 .SquaredDistance(BoxOf(tree_b.corners(g))) <= square;
    };
    return are_near_in(step.trees_before[a], step.trees_before[b]) ||
           are_near_in(near.predicted[a], near.predicted[b]);
  };
  const TriangleBvh& predicted = near.predicted[a];
  const Grouped met =
      ByFirst(predicted.CollectPairs(near.predicted[b], may_be_near, are_near),
              predicted.num_triangles());
  std::vector<std::vector<SeparatingPlane>> found(predicted.num_triangles());
#pragma omp parallel for schedule(dynamic, 64)
  for (int f = 0; f < predicted.num_triangles(); ++f) {
    if (met.count(f) == 0) continue;
    found[f] = TrianglePlanes(options, step, near, a, b, f)
                   .To(met.begin(f), met.count(f));
  }
  Append(found, planes);
  CountWork(WorkUnit::kPairsTested, met.size());
}

// Whether muscle `a` is above `b` in the planes between both. Their order has
// no part in it.
bool IsAbove(const ContactStep& step, int a, int b) {
  const auto key = [&](int i) {
    const MuscleSurface& surface = step.scene.muscles[i];
    const RowVector3d first = surface.rest.row(0);
    return std::make_tuple(
        surface.triangles.rows(), surface.volume, first[0], first[1], first[2]);
  };
  return key(a) < key(b);
}

}  // namespace

SeparatingPlane PlaneBetween(const ContactStep& step,
                             int a,
                             int f,
                             int b,
                             int g,
                             const TriangleSeparation& before,
                             double half_gap) {
  SeparatingPlane plane;
  plane.muscle_above = a;
  plane.muscle_below = b;
  plane.above = step.scene.muscles[a].triangles.row(f);
  plane.below = step.scene.muscles[b].triangles.row(g);
  const RowVector3d turned =
      before.normal * (step.rotations[a][f] + step.rotations[b][g]);
  // The rotation of a degenerate triangle is undefined.
  plane.normal = turned.norm() > 0.5 ? turned.normalized() : before.normal;
  plane.half_gap = half_gap;
  plane.distance = before.distance;
  return plane;
}

std::vector<SeparatingPlane> FindPlanesBetweenMuscles(
    const StepOptions& options,
    const ContactStep& step,
    const std::vector<TriangleBvh>& predicted) {
  const ScopedStage stage("planes between muscles");
  const std::vector<MuscleData> muscles =
      MuscleDataOf(options, step, predicted);
  std::vector<SeparatingPlane> planes;
  for (int a = 0; a < step.num_muscles(); ++a) {
    for (int b = 0; b < step.num_muscles(); ++b) {
      if (a == b || !IsAbove(step, a, b)) continue;
      if (step.is_still[a] && step.is_still[b]) continue;
      AddPlanesBetweenMuscles(
          options, step, {predicted, muscles}, a, b, &planes);
    }
  }
  return planes;
}

}  // namespace musclewarp
