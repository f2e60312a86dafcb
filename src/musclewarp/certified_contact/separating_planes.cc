// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/separating_planes.h"

#include <algorithm>
#include <cstdint>
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

// The boxes of the triangles of a muscle before the step and at the prediction,
// #F each.
struct PredictedBoxes {
  std::vector<Box3> before, predicted;
};

std::vector<PredictedBoxes> BoxesOf(const ContactStep& step,
                                    const std::vector<TriangleBvh>& predicted) {
  std::vector<PredictedBoxes> boxes(predicted.size());
  for (size_t i = 0; i < predicted.size(); ++i) {
    const int count = predicted[i].num_triangles();
    boxes[i].before.resize(count);
    boxes[i].predicted.resize(count);
#pragma omp parallel for schedule(static)
    for (int f = 0; f < count; ++f) {
      boxes[i].before[f] = BoxOf(step.trees_before[i].corners(f));
      boxes[i].predicted[f] = BoxOf(predicted[i].corners(f));
    }
  }
  return boxes;
}

// Returns boxes around both boxes of each triangle, #F. They overlap if two
// triangles are within `radius` (mm) of each other before the step or at the
// prediction.
std::vector<Box3> BoxesAround(const PredictedBoxes& boxes, double radius) {
  std::vector<Box3> around(boxes.before.size());
  for (size_t f = 0; f < around.size(); ++f) {
    around[f] = BoxOf(boxes.before[f], boxes.predicted[f]);
    for (int k = 0; k < 3; ++k) {
      around[f].lower[k] -= radius / 2;
      around[f].upper[k] += radius / 2;
    }
  }
  return around;
}

// The search radius and boxes for AddPlanesBetweenMuscles().
struct NearMuscles {
  double radius = 0;  // mm
  const std::vector<TriangleBvh>&
      predicted;  // with the boxes around the motion
  const std::vector<PredictedBoxes>& boxes;
};

void AddPlanesBetweenMuscles(const StepOptions& options,
                             const ContactStep& step,
                             const NearMuscles& near,
                             int a,
                             int b,
                             std::vector<SeparatingPlane>* planes) {
  const double square = near.radius * near.radius;
  const PredictedBoxes &boxes_a = near.boxes[a], &boxes_b = near.boxes[b];
  const auto are_near = [&](int f, int g) {
    return boxes_a.before[f].SquaredDistance(boxes_b.before[g]) <= square ||
           boxes_a.predicted[f].SquaredDistance(boxes_b.predicted[g]) <= square;
  };
  const TriangleBvh &predicted_a = near.predicted[a],
                    &predicted_b = near.predicted[b];
  const Grouped met =
      ByFirst(predicted_a.CollectOverlaps(predicted_b, are_near),
              predicted_a.num_triangles());
  std::vector<std::vector<SeparatingPlane>> found(predicted_a.num_triangles());
#pragma omp parallel for schedule(dynamic, 64)
  for (int f = 0; f < predicted_a.num_triangles(); ++f) {
    std::vector<int> others(met.begin(f), met.begin(f) + met.count(f));
    std::sort(others.begin(), others.end());
    for (const int g : others) {
      if (AreSurelyFarther(step.trees_before[a].corners(f),
                           step.trees_before[b].corners(g),
                           square) &&
          AreSurelyFarther(
              predicted_a.corners(f), predicted_b.corners(g), square)) {
        continue;
      }
      const auto separation = SeparateTriangles(
          step.trees_before[a].corners(f), step.trees_before[b].corners(g));
      if (!separation) continue;
      if (separation->distance > near.radius &&
          ClosestPointsOfTriangles(predicted_a.corners(f),
                                   predicted_b.corners(g))
                  .squared_distance > square) {
        continue;
      }
      found[f].push_back(
          PlaneBetween(step, a, f, b, g, *separation, options.AimedGap() / 2));
    }
  }
  Append(found, planes);
  CountWork(WorkUnit::kPairsTested, met.size());
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
    std::vector<TriangleBvh>* predicted) {
  const ScopedStage stage("planes between muscles");
  // Both muscles may move by the reach.
  const double radius =
      options.AimedGap() + options.planes.search_fraction * 2 * options.reach;
  const std::vector<PredictedBoxes> boxes = BoxesOf(step, *predicted);
#pragma omp parallel for schedule(dynamic, 1)
  for (int i = 0; i < step.num_muscles(); ++i) {
    (*predicted)[i].RefitBoxes(BoxesAround(boxes[i], radius));
  }
  std::vector<SeparatingPlane> planes;
  for (int a = 0; a < step.num_muscles(); ++a) {
    for (int b = a + 1; b < step.num_muscles(); ++b) {
      AddPlanesBetweenMuscles(
          options, step, {radius, *predicted, boxes}, a, b, &planes);
    }
  }
  return planes;
}

}  // namespace musclewarp
