// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/arm_joints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "joints/hand_made_shapes.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A humerus whose head covers a share of its sphere of 22 mm.
Limb LimbWithHead(double share) {
  Limb limb;
  limb.image_axes = AxesOfLps();
  limb.surfaces[BoneKind::kHumerus] =
      IdealCap({{5, 6, 7}, 22}, {1, 0, 1}, std::acos(1 - 2 * share), 4000);
  return limb;
}

TEST(FindShoulder, IsTheCentreOfTheHead) {
  const FoundJoint shoulder = FindShoulder(LimbWithHead(0.42));
  EXPECT_THAT(shoulder.verdict.reasons, IsEmpty());
  EXPECT_LT((shoulder.center - Eigen::Vector3d(5, 6, 7)).norm(), 0.01);
  EXPECT_EQ(shoulder.parent_axes, AxesOfLps());
  EXPECT_EQ(shoulder.child_axes, AxesOfLps());
  ASSERT_EQ(shoulder.shapes.size(), 1u);
  EXPECT_NEAR(shoulder.shapes[0].radius, 22, 0.01);
}

// Coverage is a share of the points, of which there are 4000.
TEST(FindShoulder, IsWeakOrFailsIfTheHeadIsCut) {
  EXPECT_EQ(FindShoulder(LimbWithHead(0.36)).verdict.quality,
            JointQuality::kGood);
  const FoundJoint cut = FindShoulder(LimbWithHead(0.3));
  EXPECT_EQ(cut.verdict.quality, JointQuality::kWeak);
  EXPECT_THAT(cut.verdict.reasons, ElementsAre(HasSubstr("covers 30 %")));
  const FoundJoint none = FindShoulder(LimbWithHead(0.25));
  EXPECT_EQ(none.verdict.quality, JointQuality::kFailed);
  EXPECT_THAT(none.shapes, IsEmpty());
}

TEST(FindShoulder, IsWeakWithoutAxesOrOnARoughHead) {
  Limb limb = LimbWithHead(0.42);
  limb.image_axes.reset();
  const FoundJoint shoulder = FindShoulder(limb);
  EXPECT_EQ(shoulder.verdict.quality, JointQuality::kWeak);
  EXPECT_EQ(shoulder.parent_axes, Eigen::Matrix3d::Identity());
  // Points are off by eleven steps from -1 to 1 in turn: 0.63 as a root mean
  // square. The fit takes half a tenth off by moving.
  const auto with_roughness = [](double off) {
    Limb rough = LimbWithHead(0.42);
    SurfacePoints& head = rough.surfaces[BoneKind::kHumerus];
    for (int i = 0; i < head.size(); ++i) {
      head.points.row(i) += off * (i * 7 % 11 - 5) / 5 * head.normals.row(i);
    }
    return FindShoulder(rough).verdict.quality;
  };
  EXPECT_EQ(with_roughness(0.7 / 0.63), JointQuality::kGood);
  EXPECT_EQ(with_roughness(0.92 / 0.63), JointQuality::kWeak);
}

// The lower end of a humerus: an hourglass about x, of which the forearm sees
// an angle about its lowest line. Ulna and radius are 3 mm away.
struct MadeElbow {
  Limb limb;

  explicit MadeElbow(double degrees) {
    limb.image_axes = AxesOfLps();
    limb.surfaces[BoneKind::kHumerus] =
        Together(Trochlea(10, 360), PointsBetween({0, 0, 20}, {0, 0, 300}));
    const SurfacePoints notch = Hollow(Trochlea(13, degrees));
    SetForearm(BoneKind::kUlna, notch, 0, 12, {12, 0, -250});
    SetForearm(BoneKind::kRadius, notch, -12, 0, {-12, 0, -250});
  }

  // An hourglass of a radius at its waist, within half of `degrees` of the
  // direction downwards.
  static SurfacePoints Trochlea(double radius, double degrees) {
    const int kAround = 120, kAlong = 25;
    SurfacePoints surface;
    surface.points.resize(kAround * kAlong, 3);
    surface.normals.resize(kAround * kAlong, 3);
    for (int i = 0; i < kAround; ++i) {
      const double angle = RadiansOf(degrees) * ((i + 0.5) / kAround - 0.5);
      for (int k = 0; k < kAlong; ++k) {
        const int from_waist = k - kAlong / 2;
        const double x = from_waist;
        const double slope = x / 60;  // of radius + x^2 / 120
        const Eigen::RowVector3d out(0, std::sin(angle), -std::cos(angle));
        const int row = kAlong * i + k;
        surface.points.row(row) = (radius + x * x / 120) * out;
        surface.points(row, 0) = x;
        surface.normals.row(row) = out - slope * Eigen::RowVector3d(1, 0, 0);
      }
    }
    surface.normals.rowwise().normalize();
    surface.area = 1;
    return surface;
  }

  // A bone of the forearm: the part of the notch between two places along its
  // axis, and a line to its end at the wrist.
  void SetForearm(BoneKind kind,
                  const SurfacePoints& notch,
                  double from,
                  double to,
                  const Eigen::Vector3d& wrist) {
    const SurfacePoints part = Filtered(notch, [&](int row) {
      return notch.points(row, 0) >= from && notch.points(row, 0) <= to;
    });
    const Eigen::Vector3d elbow((from + to) / 2, 0, -20);
    limb.surfaces[kind] = Together(part, PointsBetween(elbow, wrist));
  }
};

TEST(FindElbow, IsTheAxisOfTheTrochlea) {
  const FoundJoint elbow = FindElbow(MadeElbow(180).limb);
  EXPECT_EQ(elbow.verdict.quality, JointQuality::kGood);
  // The radius is on the right, where x is negative.
  EXPECT_LT((elbow.parent_axes - AxesOfLps()).norm(), 0.02);
  EXPECT_EQ(elbow.child_axes, elbow.parent_axes);
  EXPECT_LT(elbow.center.tail<2>().norm(), 0.2);
  ASSERT_EQ(elbow.shapes.size(), 1u);
  EXPECT_TRUE(elbow.shapes[0].is_on_parent);
  // And what sees the ends of the notch (below), in sectors of 5 degrees.
  EXPECT_GE(elbow.shapes[0].angle, M_PI);
  EXPECT_LE(elbow.shapes[0].angle, RadiansOf(180 + 2 * (13 + 5)));
}

// Points count in sectors of 5 degrees, and at the ends of the notch those
// within 46 degrees of the way there see it, too: 13 degrees on either side.
TEST(FindElbow, IsWeakOrFailsIfTheForearmSeesLittle) {
  const auto quality_of = [](double degrees) {
    return FindElbow(MadeElbow(degrees).limb).verdict.quality;
  };
  EXPECT_EQ(quality_of(130), JointQuality::kGood);
  EXPECT_EQ(quality_of(80), JointQuality::kWeak);
  EXPECT_EQ(quality_of(25), JointQuality::kFailed);
}

TEST(FindElbow, HasTheRadiusOnTheOuterSide) {
  MadeElbow made(180);
  made.limb.side = Side::kLeft;
  EXPECT_GT(FindElbow(made.limb).parent_axes(0, 2), 0.9);
  // Without a radius the image tells, and then nothing.
  made.limb.surfaces.erase(BoneKind::kRadius);
  const FoundJoint by_image = FindElbow(made.limb);
  EXPECT_LT(by_image.parent_axes(0, 2), -0.9);
  EXPECT_EQ(by_image.verdict.quality, JointQuality::kGood);
  made.limb.image_axes.reset();
  const FoundJoint unknown = FindElbow(made.limb);
  EXPECT_EQ(unknown.verdict.quality, JointQuality::kWeak);
  EXPECT_THAT(unknown.verdict.reasons,
              ElementsAre(HasSubstr("neither a radius")));
}

// Normals that are turned about the radius pass the axis: by 10 mm times the
// sine.
TEST(FindElbow, IsWeakIfNormalsPassTheAxis) {
  const auto quality_of = [](double pass) {
    MadeElbow made(180);
    SurfacePoints& humerus = made.limb.surfaces[BoneKind::kHumerus];
    for (int i = 0; i < humerus.size(); ++i) {
      const Eigen::AngleAxisd turn((i / 3 % 2 ? 1 : -1) * std::asin(pass / 10),
                                   Eigen::Vector3d::UnitX());
      humerus.normals.row(i) = turn * humerus.normals.row(i).transpose();
    }
    return FindElbow(made.limb).verdict.quality;
  };
  EXPECT_EQ(quality_of(1.2), JointQuality::kGood);
  EXPECT_EQ(quality_of(2), JointQuality::kWeak);
}

TEST(FindElbow, FailsOfBonesOfTwoScans) {
  MadeElbow made(180);
  for (const BoneKind kind : {BoneKind::kUlna, BoneKind::kRadius}) {
    made.limb.surfaces[kind].points.col(2).array() -= 20;
  }
  const FoundJoint elbow = FindElbow(made.limb);
  EXPECT_EQ(elbow.verdict.quality, JointQuality::kFailed);
  EXPECT_THAT(elbow.shapes, IsEmpty());
}

// From the head of the ulna, at the wrist, to that of the radius, at the elbow.
TEST(FindForearm, GoesAlongTheForearm) {
  const MadeElbow made(180);
  const FoundJoint forearm = FindForearm(made.limb);
  EXPECT_EQ(forearm.verdict.quality, JointQuality::kGood);
  // The last 4 % of the ulna, whose middle is 2 % from its end.
  const Eigen::Vector3d elbow = Eigen::Vector3d(-6, 0, -8);
  const Eigen::Vector3d wrist(11.9, 0, -245);
  EXPECT_LT((forearm.parent_axes.col(1) - (elbow - wrist).normalized()).norm(),
            0.01);
  EXPECT_LT((forearm.center - (elbow + wrist) / 2).norm(), 2);
  EXPECT_LT(forearm.parent_axes(0, 2), -0.9);  // the radius is on the right
  EXPECT_EQ(forearm.child_axes, forearm.parent_axes);
  ASSERT_EQ(forearm.shapes.size(), 1u);
  EXPECT_TRUE(forearm.shapes[0].is_on_parent);
  EXPECT_LT((forearm.shapes[0].direction - forearm.parent_axes.col(1)).norm(),
            1e-12);
}

TEST(FindForearm, FailsIfTheRadiusLooksAtLittleOfTheHumerus) {
  const auto quality_with = [](int points) {
    MadeElbow made(180);
    // Points right below the waist, which look up at it.
    SurfacePoints fovea = PointsBetween({-4, 0, -13}, {4, 0, -13}, points);
    fovea.normals.setZero();
    fovea.normals.col(2).setOnes();
    made.limb.surfaces[BoneKind::kRadius] = fovea;
    return FindForearm(made.limb).verdict.quality;
  };
  EXPECT_EQ(quality_with(10), JointQuality::kGood);
  EXPECT_EQ(quality_with(9), JointQuality::kFailed);
}

}  // namespace
}  // namespace musclewarp
