// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace musclewarp::phantom {
namespace {

using Eigen::Vector2d;

// Sums of a few terms of size 10.
constexpr double kCurveRounding = 1e-13;

const std::vector<Vector2d> kControls = {{0, 0}, {4, 1}, {5, 6}, {-2, 3}};

TEST(SampleCatmullRom, AnOpenCurveRunsThroughItsControls) {
  constexpr int kSamples = 5;
  const auto curve = SampleCatmullRom(kControls, kSamples, false);
  ASSERT_EQ(curve.size(), (kControls.size() - 1) * kSamples + 1);
  for (size_t i = 0; i < kControls.size(); ++i) {
    EXPECT_EQ(curve[i * kSamples], kControls[i]);
  }
}

TEST(SampleCatmullRom, AClosedCurveDoesNotRepeatItsFirstPoint) {
  const auto curve = SampleCatmullRom(kControls, 5, true);
  ASSERT_EQ(curve.size(), kControls.size() * 5);
  for (size_t i = 0; i < kControls.size(); ++i) {
    EXPECT_EQ(curve[i * 5], kControls[i]);
  }
  EXPECT_NE(curve.back(), curve.front());
}

TEST(SampleCatmullRom, TwoControlsGiveASegment) {
  for (const Vector2d& p :
       SampleCatmullRom<Vector2d>({{0, 0}, {4, 2}}, 8, false)) {
    EXPECT_EQ(p.x(), 2 * p.y());
  }
}

TEST(SampleCatmullRom, EqualStepsOnALineStayEqual) {
  const auto curve =
      SampleCatmullRom<Vector2d>({{0, 0}, {4, 0}, {8, 0}, {12, 0}}, 4, false);
  // Not in the end spans, whose outer control is doubled.
  for (int i = 4; i <= 8; ++i) EXPECT_EQ(curve[i], Vector2d(i, 0));
}

TEST(SampleCatmullRom, TheTangentAtAControlIsParallelToItsNeighbours) {
  // So fine that the curve is straight to a ten thousandth.
  constexpr int kSamples = 10000;
  const auto curve = SampleCatmullRom(kControls, kSamples, true);
  const Vector2d before = curve[kSamples] - curve[kSamples - 1];
  const Vector2d after = curve[kSamples + 1] - curve[kSamples];
  const Vector2d expected = (kControls[2] - kControls[0]) / 2 / kSamples;
  EXPECT_LT((before - expected).norm(), 1e-3 * expected.norm());
  EXPECT_LT((after - expected).norm(), 1e-3 * expected.norm());
}

TEST(Outline, IsNegativeInside) {
  const Outline outline(kControls);
  EXPECT_LT(outline.SignedDistance({2, 3}), 0);
  EXPECT_GT(outline.SignedDistance({10, 3}), 0);
  EXPECT_GT(outline.SignedDistance({2, -5}), 0);
  for (const Vector2d& control : kControls) {
    EXPECT_EQ(std::abs(outline.SignedDistance(control)), 0);
  }
}

TEST(Outline, DoesNotDependOnTheDirectionOfItsControls) {
  const Outline outline(kControls);
  const Outline reversed(
      std::vector<Vector2d>(kControls.rbegin(), kControls.rend()));
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-10, 10);
  for (int i = 0; i < 1000; ++i) {
    const Vector2d p(place(random), place(random));
    EXPECT_NEAR(
        outline.SignedDistance(p), reversed.SignedDistance(p), kCurveRounding);
  }
}

// All edges are compared here, without boxes.
TEST(Outline, HasTheDistanceToTheNearestEdge) {
  const Outline outline(kControls);
  auto curve = SampleCatmullRom(kControls, 4, true);
  curve.push_back(curve.front());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-10, 10);
  for (int i = 0; i < 1000; ++i) {
    const Vector2d p(place(random), place(random));
    double nearest = INFINITY;
    for (size_t k = 0; k + 1 < curve.size(); ++k) {
      const Vector2d along = curve[k + 1] - curve[k];
      const double t = (p - curve[k]).dot(along) / along.squaredNorm();
      nearest = std::min(
          nearest,
          (p - curve[k] - std::min(std::max(t, 0.0), 1.0) * along).norm());
    }
    EXPECT_NEAR(std::abs(outline.SignedDistance(p)), nearest, kCurveRounding);
  }
}

TEST(Outline, OfManyPointsOnACircleIsTheCircle) {
  std::vector<Vector2d> controls;
  for (int i = 0; i < 32; ++i) {
    const double angle = i * 2 * M_PI / 32;
    controls.emplace_back(10 * std::cos(angle), 10 * std::sin(angle));
  }
  const Outline circle(controls);
  // A chord of 1/192 of the circle, and the cubic between the controls, leave
  // it by less than 0.01.
  constexpr double kTolerance = 0.01;
  for (const double radius : {2.0, 9.0, 12.0, 20.0}) {
    for (double angle = 0.1; angle < 6; angle += 0.7) {
      const Vector2d p(radius * std::cos(angle), radius * std::sin(angle));
      EXPECT_NEAR(circle.SignedDistance(p), radius - 10, kTolerance);
    }
  }
}

}  // namespace
}  // namespace musclewarp::phantom
