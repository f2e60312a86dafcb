// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/angles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace musclewarp {
namespace {

// Each of the four operations rounds by half an epsilon at most.
void ExpectEqualToRounding(double a, double b) {
  EXPECT_NEAR(a, b, 2 * std::numeric_limits<double>::epsilon() * std::abs(b));
}

TEST(Angles, HalfATurnIsPi) {
  static_assert(RadiansOf(180) == M_PI);
  static_assert(DegreesOf(M_PI) == 180);
  static_assert(RadiansOf(0) == 0 && DegreesOf(0) == 0);
}

TEST(Angles, AreTheSameThereAndBack) {
  for (int i = -7200; i <= 7200; ++i) {
    const double angle = 0.1 * i;
    ExpectEqualToRounding(DegreesOf(RadiansOf(angle)), angle);
    ExpectEqualToRounding(RadiansOf(DegreesOf(angle)), angle);
  }
}

TEST(Angles, FactorsAreThoseOfTheFunctions) {
  for (int i = -7200; i <= 7200; ++i) {
    const double angle = 0.1 * i;
    ExpectEqualToRounding(angle * kRadiansPerDegree, RadiansOf(angle));
    ExpectEqualToRounding(angle * kDegreesPerRadian, DegreesOf(angle));
  }
}

}  // namespace
}  // namespace musclewarp
