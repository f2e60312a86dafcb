// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/coordinate_limits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "musclewarp/base/infinity.h"
#include "support/input_errors.h"

namespace musclewarp {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

TEST(CheckCoordinates, AcceptsPointsUpToTheLimit) {
  Points points = Points::Constant(2, 3, kLargestCoordinate);
  points.row(1) *= -1;
  EXPECT_NO_THROW(CheckCoordinates("mesh.ply", points));
  EXPECT_NO_THROW(CheckCoordinates("mesh.ply", Points(0, 3)));
}

TEST(CheckCoordinates, NamesThePointThatIsTooFarOrNoNumber) {
  for (const double value : {std::nextafter(kLargestCoordinate, kInfinity),
                             -2 * kLargestCoordinate,
                             1e308,
                             kInfinity,
                             kNan}) {
    Points points = Points::Zero(4, 3);
    points(2, 1) = value;
    ExpectInputError([&] { CheckCoordinates("mesh.ply", points); },
                     {"mesh.ply: point 2", "(0, ", "allowed: -1e7 to 1e7 mm"});
  }
}

TEST(CheckCoordinates, LooksAtTheWholeTransform) {
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  transform(1, 3) = kLargestCoordinate;
  EXPECT_NO_THROW(CheckCoordinates("pose", transform));
  transform(1, 3) *= 2;
  ExpectInputError([&] { CheckCoordinates("pose", transform); },
                   {"pose", "(0, 2e+07, 0)", "allowed"});
  transform(1, 3) = 0;
  transform(0, 0) = kNan;
  ExpectInputError([&] { CheckCoordinates("pose", transform); }, {"pose"});
}

}  // namespace
}  // namespace musclewarp
