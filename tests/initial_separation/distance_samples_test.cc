// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/distance_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "initial_separation/solid.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

double DistanceToSphere(const RowVector3d& p) {
  return (p - RowVector3d(1, 2, 3)).norm() - 20;
}

// To the box [-15, 15] x [-10, 10] x [-25, 25].
double DistanceToBox(const RowVector3d& p) {
  const RowVector3d beyond = p.cwiseAbs() - RowVector3d(15, 10, 25);
  return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
}

const Box3 kSampledBox = {{-40, -40, -40}, {45, 41, 42}};

// Expects the values that are promised at all points, and that some of them
// were not sampled point by point.
void ExpectLikeFunction(const SignedDistanceFunction& function,
                        double spacing) {
  const DistanceSamples samples(function, kSampledBox, spacing);
  int num_smaller = 0;
  for (std::int64_t i = 0; i < samples.size().prod(); ++i) {
    const double expected = function(samples.Position(i));
    const double value = samples.value(i);
    ASSERT_EQ(value < 0, expected < 0) << samples.Position(i);
    ASSERT_LE(std::abs(value), std::abs(expected) + kDistanceRounding);
    if (std::abs(expected) <= 2 * spacing) {
      ASSERT_EQ(value, expected) << samples.Position(i);
    }
    num_smaller += std::abs(value) < std::abs(expected) - kDistanceRounding;
  }
  EXPECT_GT(num_smaller, 0);
}

}  // namespace

TEST(DistanceSamples, HaveTheSignOfASphereAndItsValuesNearTheSurface) {
  ExpectLikeFunction(DistanceToSphere, 1);
}

TEST(DistanceSamples, HaveTheSignOfABoxAndItsValuesNearTheSurface) {
  ExpectLikeFunction(DistanceToBox, 0.7);
}

TEST(DistanceSamples, CoverTheBoxAndOnePointBeyond) {
  const DistanceSamples samples(DistanceToSphere, kSampledBox, 3);
  const RowVector3d first = samples.Position(0);
  const RowVector3d last = samples.Position(samples.size().prod() - 1);
  EXPECT_EQ(first, RowVector3d(-45, -45, -45));
  EXPECT_EQ(last, RowVector3d(48, 45, 45));
  for (const RowVector3d& p : {first, last}) {
    EXPECT_EQ(p, 3 * (p / 3).array().round().matrix());
  }
}

TEST(DistanceSamples, AreTheSameInAnotherBox) {
  // Two boxes have their points in common, so that surfaces can be compared.
  const DistanceSamples large(DistanceToSphere, kSampledBox, 2);
  const Box3 inner = {{-7.5, -3.5, 15}, {11, 9, 31}};
  const DistanceSamples small(DistanceToSphere, inner, 2);
  for (std::int64_t i = 0; i < small.size().prod(); ++i) {
    const RowVector3d p = small.Position(i);
    EXPECT_EQ(large.Position(large.NearestTo(p)), p);
  }
}

TEST(DistanceSamples, FindThePointNearestToAPlace) {
  const double spacing = 1.5;
  const DistanceSamples samples(DistanceToSphere, kSampledBox, spacing);
  const Points places = 40 * RandomPoints(1000, 1);
  for (const auto p : places.rowwise()) {
    const std::int64_t nearest = samples.NearestTo(p);
    ASSERT_GE(nearest, 0);
    EXPECT_LE((samples.Position(nearest) - p).cwiseAbs().maxCoeff(),
              spacing / 2 + kDistanceRounding);
  }
  EXPECT_EQ(samples.NearestTo({100, 0, 0}), -1);
  EXPECT_EQ(samples.NearestTo({0, -100, 0}), -1);
  const RowVector3d last = samples.Position(samples.size().prod() - 1);
  EXPECT_EQ(samples.NearestTo(last), samples.size().prod() - 1);
  EXPECT_EQ(samples.NearestTo(last + RowVector3d(0, 0, 0.6 * spacing)), -1);
  EXPECT_GE(samples.NearestTo(last + RowVector3d(0, 0, 0.4 * spacing)), 0);
}

TEST(DistanceSamplesDeathTest, NeedASpacingAboveZero) {
  EXPECT_DEATH(DistanceSamples(DistanceToSphere, kSampledBox, 0), "spacing");
}

}  // namespace musclewarp
