// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/proximity/box_octet.h"

#include <gtest/gtest.h>

#include <random>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// Bounds that were too high would hide the closest triangle; bounds that are
// too low only cost time. 1e-4 of the distance and of the size of coordinates
// is a thousand times what single precision rounds by.
TEST(BoxOctet, BoundsAreBelowSquaredDistancesByRoundingOnly) {
  std::mt19937 random(3);
  for (const double centre : {0.0, 1.0, 1500.0}) {
    std::uniform_real_distribution<double> near(centre - 5, centre + 5);
    for (int trial = 0; trial < 200; ++trial) {
      BoxOctet octet;
      std::array<Box3, BoxOctet::kSize> boxes;
      for (int lane = 0; lane < BoxOctet::kSize; ++lane) {
        for (int k = 0; k < 3; ++k) {
          const double a = near(random), b = near(random);
          boxes[lane].lower[k] = std::min(a, b);
          boxes[lane].upper[k] = std::max(a, b);
        }
        octet.SetBox(lane, boxes[lane]);
      }
      const RowVector3d p(near(random), near(random), near(random));
      const BoxOctet::Values bounds =
          BoundSquaredDistances(octet, OctetQuery(p));
      for (int lane = 0; lane < BoxOctet::kSize; ++lane) {
        const double square = boxes[lane].SquaredDistance(p);
        EXPECT_LE(bounds[lane], square);
        EXPECT_GE(std::sqrt(bounds[lane]),
                  std::sqrt(square) - 1e-6 * (centre + 10) -
                      1e-4 * std::sqrt(square));
      }
    }
  }
}

TEST(BoxOctet, PointsOnTheBoundaryAreWithinTheBox) {
  BoxOctet octet;
  octet.SetBox(0, Box3{{0.1, 0.2, 0.3}, {1.1, 1.2, 1.3}});
  for (const double x : {0.1, 1.1}) {
    const OctetQuery query(RowVector3d(x, 0.7, 1.3));
    EXPECT_EQ(BoundSquaredDistances(octet, query)[0], 0);
  }
}

}  // namespace
}  // namespace musclewarp
