// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/bone_planes.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/stage_times.h"
#include "musclewarp/base/work_counts.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/proximity/triangle_separation.h"

namespace musclewarp {
namespace {

// Rounding of a distance between two places, mm, is below this.
constexpr double kRounding = 1e-9;

// Returns the distance that matters to a triangle that stands still, mm.
double Margin(const StepOptions& options, const ContactStep& step, int muscle) {
  return options.AimedGap() +
         options.planes.search_fraction * ReachOf(options, step, muscle);
}

// Returns the distance beyond which nothing matters to a triangle, mm.
double LargestNeed(const StepOptions& options,
                   const ContactStep& step,
                   int muscle) {
  return Margin(options, step, muscle) + 2 * options.relaxation.max_push;
}

// Returns true if a bone is too far from a muscle to matter to it in a step.
bool IsFar(const StepOptions& options,
           const ContactStep& step,
           int muscle,
           int bone) {
  const Box3 box = Transformed(step.scene.bones[bone]->box(),
                               step.before.bones_from_rest[bone]);
  const double need = LargestNeed(options, step, muscle);
  return step.trees_before[muscle].box().SquaredDistance(box) > need * need;
}

// Returns a lower bound of the distance of the bone's triangles from `box`: the
// distance of their boxes if it is below `exact_below`, mm, else at least half
// of it.
double DistanceBound(const TriangleBvh& bone,
                     const Box3& box,
                     double exact_below) {
  const double exact_square = exact_below * exact_below;
  double least = kInfinity, limit = kInfinity;
  bone.TraverseNearestFirst(
      [&](const Box3& other) { return other.SquaredDistance(box); },
      [&](int triangle) {
        least =
            std::min(least, BoxOf(bone.corners(triangle)).SquaredDistance(box));
        limit = std::min(least, std::max(least / 4, exact_square));
      },
      &limit);
  return std::sqrt(limit);
}

// The search for the planes of one bone against one muscle in a step. Its
// places are in the frame of the bone at rest, mm.
class BoneSearch {
 public:
  BoneSearch(const StepOptions& options,
             const ContactStep& step,
             int muscle,
             int bone)
      : options_(options),
        step_(step),
        surface_(step.scene.muscles[muscle]),
        obstacles_(*step.scene.bones[bone]),
        muscle_(muscle),
        bone_(bone),
        max_push_(options.relaxation.max_push),
        margin_(Margin(options, step, muscle)),
        rest_from_after_(RigidInverse(step.bones_from_rest[bone])),
        before_(Transformed(step.before.points[muscle],
                            RigidInverse(step.before.bones_from_rest[bone]))) {}

  // Appends the planes of the step to `planes`. `kept`: those of the step
  // before, null if there are none.
  KeptPlanes Find(const KeptPlanes* kept,
                  std::vector<SeparatingPlane>* planes) const;

 private:
  // The path of a triangle in this step.
  struct Path {
    Corners before, predicted;
    double move;  // the largest of a corner, mm
    double need;  // parts of the bone farther from `before` do not matter, mm
  };

  // The planes of a triangle in this step.
  struct Guarded {
    int triangle = -1;
    int kept = -1;                      // index of its kept planes
    std::vector<HalfSpace> new_spaces;  // if there are none
    double radius = 0;     // of new planes, as in GuardedTriangle, or 0 of
                           // planes that are not to be kept
    double clearance = 0;  // as in Clearances
  };

  Path PathOf(int f) const;

  // Returns the triangles that the bone may matter to. `distances` receives
  // lower bounds of the distances of all triangles before the step.
  std::vector<int> TrianglesNear(const KeptPlanes* kept,
                                 std::vector<double>* distances) const;

  Guarded Guard(const KeptPlanes* kept, int f, double clearance) const;
  void FindAnew(const Path& path, Guarded* guarded) const;

  // The same for a triangle that moves fast in the frame of the bone: its
  // planes serve this step only.
  void FindOnPath(const Path& path, Guarded* guarded) const;

  // Finds planes against those triangles of the bone for which enter(box) is
  // true.
  template <typename Enter>
  ObstacleSeparation Separate(const Corners& triangle,
                              double radius,
                              const Enter& enter) const;

  const StepOptions& options_;
  const ContactStep& step_;
  const MuscleSurface& surface_;
  const TriangleBvh& obstacles_;
  int muscle_, bone_;
  double max_push_;
  double margin_;  // the distance that matters to a triangle that stands still
  Eigen::Matrix4d rest_from_after_;
  Points before_;  // #V x 3: the vertices before the step
};

BoneSearch::Path BoneSearch::PathOf(int f) const {
  const Eigen::RowVector3i& triangle = surface_.triangles.row(f);
  Path path;
  path.before = CornersOf(before_, triangle);
  path.predicted = CornersOf(step_.predicted[muscle_], triangle) *
                   rest_from_after_.topLeftCorner<3, 3>().transpose();
  path.predicted.rowwise() +=
      rest_from_after_.topRightCorner<3, 1>().transpose();
  path.move = (path.predicted - path.before).rowwise().norm().maxCoeff();
  path.need = margin_ + std::min(1.5 * path.move, 2 * max_push_);
  return path;
}

std::vector<int> BoneSearch::TrianglesNear(
    const KeptPlanes* kept, std::vector<double>* distances) const {
  const int count = static_cast<int>(surface_.triangles.rows());
  const double largest_need = LargestNeed(options_, step_, muscle_);
  const Clearances* known = nullptr;
  Eigen::VectorXd moved;  // of the vertices since `known`, mm
  if (kept != nullptr && !kept->clearances.distances.empty()) {
    known = &kept->clearances;
    moved = (before_ - known->places).rowwise().norm().array() + kRounding;
  }
  distances->resize(count);
  std::vector<char> is_near(count);
#pragma omp parallel for schedule(static)
  for (int f = 0; f < count; ++f) {
    double& distance = (*distances)[f];
    distance = 0;
    if (known != nullptr) {
      const int* v = surface_.triangles.row(f).data();
      distance = known->distances[f] -
                 std::max({moved[v[0]], moved[v[1]], moved[v[2]]});
    }
    is_near[f] = !surface_.IsExempt(bone_, f) && distance < largest_need;
  }
  std::vector<int> near;
  for (int f = 0; f < count; ++f) {
    if (is_near[f]) near.push_back(f);
  }
  return near;
}

template <typename Enter>
ObstacleSeparation BoneSearch::Separate(const Corners& triangle,
                                        double radius,
                                        const Enter& enter) const {
  std::vector<int> near;
  obstacles_.Traverse(enter, [&](int g) { near.push_back(g); });
  CountWork(WorkUnit::kPairsTested, static_cast<std::int64_t>(near.size()));
  ObstacleOptions nearby;
  nearby.radius = radius;
  nearby.gap = options_.AimedGap();
  nearby.overlooked_fraction = options_.planes.overlooked_fraction;
  nearby.max_planes = options_.planes.max_planes_per_triangle;
  return SeparateFromObstacles(
      triangle, obstacles_, near.data(), static_cast<int>(near.size()), nearby);
}

void BoneSearch::FindOnPath(const Path& path, Guarded* guarded) const {
  const Box3 around =
      BoxOf(BoxOf(path.before, margin_), BoxOf(path.predicted, margin_));
  guarded->new_spaces =
      Separate(path.before, path.need, [&](const Box3& other) {
        return other.Overlaps(around);
      }).spaces;
}

void BoneSearch::FindAnew(const Path& path, Guarded* guarded) const {
  const double radius = path.need + options_.planes.kept_slack;
  const Box3 box = BoxOf(path.before);
  const auto separate_within = [&](double distance) {
    return Separate(path.before, distance, [&](const Box3& other) {
      return other.SquaredDistance(box) <= distance * distance;
    });
  };
  guarded->clearance = DistanceBound(obstacles_, box, radius);
  if (guarded->clearance >= path.need) return;
  ObstacleSeparation found = separate_within(radius);
  // Whether there are planes must not depend on what is known from steps
  // before: where the lower bound does not tell, the distance itself does.
  const bool is_far =
      found.distance > path.need || (found.distance_of_first > path.need &&
                                     separate_within(path.need).spaces.empty());
  if (is_far) {
    // Nothing is known of the distance of a triangle that touches the bone.
    guarded->clearance =
        found.touches ? 0
                      : std::min(std::max(found.distance, path.need), radius);
    return;
  }
  guarded->new_spaces = std::move(found.spaces);
  guarded->radius = radius;
  guarded->clearance = -1;
}

BoneSearch::Guarded BoneSearch::Guard(const KeptPlanes* kept,
                                      int f,
                                      double clearance) const {
  Guarded guarded;
  guarded.triangle = f;
  guarded.clearance = std::max(0.0, clearance);
  const double slack = options_.planes.kept_slack;
  const Path path = PathOf(f);
  if (kept != nullptr) {
    const auto found = std::lower_bound(
        kept->triangles.begin(),
        kept->triangles.end(),
        f,
        [](const GuardedTriangle& a, int b) { return a.triangle < b; });
    if (found != kept->triangles.end() && found->triangle == f) {
      const double moved =
          (path.before - found->corners).rowwise().norm().maxCoeff();
      if (moved <= slack && moved + path.need <= found->radius) {
        guarded.kept = static_cast<int>(found - kept->triangles.begin());
        guarded.clearance = -1;
        return guarded;
      }
    }
  }
  if (guarded.clearance >= path.need) return guarded;
  if (path.move > slack) {
    FindOnPath(path, &guarded);
  } else {
    FindAnew(path, &guarded);
  }
  return guarded;
}

KeptPlanes BoneSearch::Find(const KeptPlanes* kept,
                            std::vector<SeparatingPlane>* planes) const {
  KeptPlanes next;
  std::vector<double>& distances = next.clearances.distances;
  const std::vector<int> near = TrianglesNear(kept, &distances);
  std::vector<Guarded> all(near.size());
#pragma omp parallel for schedule(dynamic, 64)
  for (size_t k = 0; k < near.size(); ++k) {
    all[k] = Guard(kept, near[k], distances[near[k]]);
  }
  const auto add = [&](GuardedTriangle triangle, const HalfSpace* spaces) {
    triangle.first_space = static_cast<int>(next.spaces.size());
    next.spaces.insert(next.spaces.end(), spaces, spaces + triangle.num_spaces);
    next.triangles.push_back(triangle);
  };
  for (const Guarded& guarded : all) {
    const int f = guarded.triangle;
    const HalfSpace* spaces = guarded.new_spaces.data();
    int count = static_cast<int>(guarded.new_spaces.size());
    distances[f] = guarded.clearance;
    if (guarded.kept >= 0) {
      const GuardedTriangle& triangle = kept->triangles[guarded.kept];
      spaces = kept->spaces.data() + triangle.first_space;
      count = triangle.num_spaces;
      add(triangle, spaces);
    } else if (guarded.radius > 0) {
      add({f,
           CornersOf(before_, surface_.triangles.row(f)),
           guarded.radius,
           0,
           count},
          spaces);
    }
    for (int k = 0; k < count; ++k) {
      planes->push_back(PlaneOfBone(step_, muscle_, f, bone_, spaces[k]));
    }
  }
  next.clearances.places = before_;
  return next;
}

}  // namespace

SeparatingPlane PlaneOfBone(const ContactStep& step,
                            int muscle,
                            int f,
                            int bone,
                            const HalfSpace& at_rest) {
  const Eigen::Matrix4d& place = step.bones_from_rest[bone];
  SeparatingPlane plane;
  plane.muscle_above = muscle;
  plane.bone = bone;
  plane.above = step.scene.muscles[muscle].triangles.row(f);
  plane.normal = at_rest.normal * place.topLeftCorner<3, 3>().transpose();
  plane.level = at_rest.level + plane.normal.dot(place.topRightCorner<3, 1>());
  return plane;
}

std::vector<SeparatingPlane> FindPlanesOfBones(const StepOptions& options,
                                               const ContactStep& step,
                                               KeptBonePlanes* kept) {
  const ScopedStage stage("planes of bones");
  const KeptBonePlanes* before = step.before.bone_planes.get();
  KeptBonePlanes next(step.num_muscles() * step.num_bones());
  if (before != nullptr) CHECK_EQ(before->size(), next.size());
  std::vector<SeparatingPlane> planes;
  for (int bone = 0; bone < step.num_bones(); ++bone) {
    if (step.scene.bones[bone]->num_triangles() == 0) continue;
    for (int i = 0; i < step.num_muscles(); ++i) {
      const int pair = i * step.num_bones() + bone;
      if (step.is_still[i]) {
        if (before != nullptr) next[pair] = (*before)[pair];
        continue;
      }
      if (IsFar(options, step, i, bone)) continue;
      next[pair] =
          BoneSearch(options, step, i, bone)
              .Find(before == nullptr ? nullptr : &(*before)[pair], &planes);
    }
  }
  *kept = std::move(next);
  return planes;
}

}  // namespace musclewarp
