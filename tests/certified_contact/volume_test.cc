// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "certified_contact/contact_group.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

struct Squeezed {
  ContactGroup group;
  StepOptions options;
  ContactStep step = MakeContactStep(group.scene,
                                     group.state,
                                     group.state.targets,
                                     group.state.bones_from_rest);
  PlaneSet planes{options, step};
  RelaxedPoints relaxed = StartOf(step);

  explicit Squeezed(double factor, ContactGroup squeezed = SpheresOverABone())
      : group(std::move(squeezed)) {
    planes.Add(AllPlanes(options, step));
    for (int i = 0; i < step.num_muscles(); ++i) {
      const Eigen::RowVector3d centre = relaxed.points[i].colwise().mean();
      relaxed.points[i] =
          (factor * (relaxed.points[i].rowwise() - centre)).rowwise() + centre;
    }
    relaxed.unprojected = relaxed.points;
  }
  double ErrorOf(int muscle, const Points& points) const {
    const MuscleSurface& surface = group.scene.muscles[muscle];
    return std::abs(SignedVolume(points, surface.triangles) / surface.volume -
                    1);
  }
};

TEST(RestoreVolumes, BringsVolumesBackWithinTheTolerance) {
  for (const double factor : {0.99, 1.003}) {
    Squeezed squeezed(factor);
    const RestoredVolumes restored = RestoreVolumes(
        squeezed.options, squeezed.step, squeezed.relaxed, &squeezed.planes);
    EXPECT_LE(restored.worst_error, squeezed.options.volume.tolerance);
    for (int i = 0; i < 2; ++i) {
      EXPECT_LE(squeezed.ErrorOf(i, restored.points[i]),
                squeezed.options.volume.tolerance);
      // The gap to the bone is kept.
      EXPECT_GE(restored.points[i].col(2).minCoeff(),
                squeezed.options.gap - 1e-8);
    }
  }
}

TEST(RestoreVolumes, LeavesHeldVerticesWhereTheyAre) {
  Squeezed squeezed(0.99);
  // The lower half counts as held: planes have moved it.
  Points& points = squeezed.relaxed.points[0];
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    if (points(v, 2) < 10) squeezed.relaxed.unprojected[0](v, 2) -= 0.1;
  }
  const RestoredVolumes restored = RestoreVolumes(
      squeezed.options, squeezed.step, squeezed.relaxed, &squeezed.planes);
  EXPECT_LE(restored.worst_error, squeezed.options.volume.tolerance);
  int held = 0;
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    if (points(v, 2) >= 10) continue;
    ++held;
    EXPECT_EQ(restored.points[0].row(v), points.row(v));
  }
  EXPECT_GT(held, 100);
}

TEST(RestoreVolumes, LeavesAttachedVerticesWhereTheyAre) {
  Squeezed squeezed(0.99);
  const Points& points = squeezed.relaxed.points[0];
  std::vector<int>& attached = squeezed.step.attached[0].vertices;
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    if (points(v, 2) > 10) attached.push_back(static_cast<int>(v));
  }
  ASSERT_GT(attached.size(), 50u);
  const RestoredVolumes restored = RestoreVolumes(
      squeezed.options, squeezed.step, squeezed.relaxed, &squeezed.planes);
  EXPECT_LE(restored.worst_error, squeezed.options.volume.tolerance);
  EXPECT_EQ(Points(restored.points[0](attached, Eigen::all)),
            Points(points(attached, Eigen::all)));
}

TEST(RestoreVolumes, SaysWhatIsLeftWhereAllVerticesAreHeld) {
  Squeezed squeezed(0.99);
  for (Points& points : squeezed.relaxed.unprojected) {
    points.array() += 0.1;
  }
  const RestoredVolumes restored = RestoreVolumes(
      squeezed.options, squeezed.step, squeezed.relaxed, &squeezed.planes);
  EXPECT_NEAR(restored.worst_error, 1 - std::pow(0.99, 3), 1e-9);
  EXPECT_EQ(restored.points[0], squeezed.relaxed.points[0]);
}

// A sphere with nothing around it, about the origin.
Squeezed SqueezedAlone(double factor) {
  return Squeezed(factor, ContactGroup({SphereAt({0, 0, 0}, 10, 3)}, {}));
}

TEST(RestoreVolumes, MovesVerticesBesideHeldOnesLess) {
  Squeezed squeezed = SqueezedAlone(0.99);
  const Points& points = squeezed.relaxed.points[0];
  const auto is_held = [&](int v) { return points(v, 2) < 0; };
  for (int v = 0; v < points.rows(); ++v) {
    if (is_held(v)) squeezed.relaxed.unprojected[0](v, 2) -= 0.1;
  }
  const RestoredVolumes restored = RestoreVolumes(
      squeezed.options, squeezed.step, squeezed.relaxed, &squeezed.planes);
  const Eigen::VectorXd moves = (restored.points[0] - points).rowwise().norm();
  const MuscleSurface& surface = squeezed.group.scene.muscles[0];
  double most_beside = 0;
  for (int v = 0; v < surface.num_vertices(); ++v) {
    if (is_held(v)) continue;
    for (int e = surface.first[v]; e < surface.first[v + 1]; ++e) {
      if (!is_held(surface.neighbours[e])) continue;
      most_beside = std::max(most_beside, moves[v]);
    }
  }
  EXPECT_GT(most_beside, 0);
  EXPECT_LT(most_beside, 0.8 * moves.maxCoeff());
}

TEST(RestoreVolumes, MovesNoVertexByMoreThanTheReachInOneStep) {
  Squeezed squeezed = SqueezedAlone(0.5);  // 5 mm are missing all around
  squeezed.options.volume.max_steps = 1;
  const RestoredVolumes restored = RestoreVolumes(
      squeezed.options, squeezed.step, squeezed.relaxed, &squeezed.planes);
  EXPECT_NEAR((restored.points[0] - squeezed.relaxed.points[0])
                  .rowwise()
                  .norm()
                  .maxCoeff(),
              squeezed.options.reach,
              1e-9);
}

// What is then still missing is left to the pressure of the steps that follow.
TEST(RestoreVolumes, EndsWhereAVertexHasMovedByTheLimit) {
  constexpr double kLimit = 0.05;  // of 10 mm, 1 % is 0.1 mm
  Squeezed squeezed(0.99);
  squeezed.options.volume.max_move = kLimit;
  PlaneSet none(squeezed.options, squeezed.step);
  const RestoredVolumes restored =
      RestoreVolumes(squeezed.options, squeezed.step, squeezed.relaxed, &none);
  for (int i = 0; i < 2; ++i) {
    const double volume = squeezed.group.scene.muscles[i].volume;
    EXPECT_TRUE(restored.is_limited[i]);
    // 0.99^3 of it is there.
    EXPECT_NEAR(restored.missing[i] / volume, 0.0297, 1e-4);
    EXPECT_LT((restored.points[i] - squeezed.relaxed.points[i])
                  .rowwise()
                  .norm()
                  .maxCoeff(),
              kLimit + 1e-9);
    EXPECT_LT(squeezed.ErrorOf(i, restored.points[i]),
              squeezed.ErrorOf(i, squeezed.relaxed.points[i]));
  }
}

}  // namespace
}  // namespace musclewarp
