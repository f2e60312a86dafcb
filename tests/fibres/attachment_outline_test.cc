// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/attachment_outline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace musclewarp {
namespace {

// A ball of radius 30 mm in a bone of 30.5 mm: each of its vertices lies half a
// millimetre from the bone.
const TriangleSoup& Muscle() {
  static const TriangleSoup kMuscle = SphereAt({0, 0, 0}, 30, 4);
  return kMuscle;
}

const std::vector<BodySurface>& Pelvis() {
  static const TriangleSoup kMesh = SphereAt({0, 0, 0}, 30.5, 4);
  static const TriangleBvh kBone(kMesh.points, kMesh.triangles);
  static const std::vector<BodySurface> kBodies = {{"pelvis", {&kBone}}};
  return kBodies;
}

// A circle on the ball about its top, 60 degrees from it.
Attachment Circle() {
  Attachment outline;
  outline.body = "pelvis";
  outline.points.resize(24, 3);
  for (int i = 0; i < 24; ++i) {
    const double angle = 2 * M_PI * i / 24;
    outline.points.row(i) << 26 * std::cos(angle), 26 * std::sin(angle), 15;
  }
  outline.radius = 4;
  outline.is_outline = true;
  return outline;
}

}  // namespace

// Inside of the circle is the cap of the ball above it; what is near the circle
// belongs to it, too. The bottom of the ball, which is seen inside of it, does
// not.
TEST(FilledOutline, HasTheInsideOfTheOutline) {
  const Attachment filled = FilledOutline(Circle(), Muscle(), Pelvis());
  EXPECT_FALSE(filled.is_outline);
  EXPECT_EQ(filled.body, "pelvis");
  EXPECT_EQ(filled.radius, kPointsAlone);
  Eigen::Index in_cap = 0, above_circle = 0;
  for (Eigen::Index v = 0; v < Muscle().points.rows(); ++v) {
    in_cap += Muscle().points(v, 2) > 15;
  }
  for (Eigen::Index v = 0; v < filled.points.rows(); ++v) {
    above_circle += filled.points(v, 2) > 15;
    EXPECT_GT(filled.points(v, 2), 15 - Circle().radius);
  }
  EXPECT_GT(in_cap, 100);
  EXPECT_EQ(above_circle, in_cap);
  EXPECT_GT(filled.points.rows(), in_cap);
}

// The order of the points turns round which way the outline is seen.
TEST(FilledOutline, DoesNotDependOnItsDirection) {
  Attachment back = Circle();
  back.points = Circle().points.colwise().reverse().eval();
  EXPECT_EQ(FilledOutline(back, Muscle(), Pelvis()).points,
            FilledOutline(Circle(), Muscle(), Pelvis()).points);
}

TEST(FilledOutline, InsideIsNearABoneOfTheBody) {
  Attachment other = Circle();
  other.body = "femur";
  const Attachment filled = FilledOutline(other, Muscle(), Pelvis());
  EXPECT_GT(filled.points.rows(), 0);
  EXPECT_LT(filled.points.col(2).maxCoeff(), 15 + other.radius);
}

TEST(FilledOutline, KeepsAnOutlineFarFromTheMuscle) {
  Attachment far = Circle();
  far.points.col(0).array() += 200;
  const Attachment kept = FilledOutline(far, Muscle(), Pelvis());
  EXPECT_EQ(kept.points, far.points);
  EXPECT_EQ(kept.radius, far.radius);
}

}  // namespace musclewarp
