// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/image_directions.h"

#include <gtest/gtest.h>

namespace musclewarp {
namespace {

TEST(DirectionsOfAxes, AreForwardUpAndRight) {
  Eigen::Matrix3d of_image;
  of_image << 0, 0, -1, -1, 0, 0, 0, 1, 0;
  EXPECT_EQ(DirectionsOfAxes("LPS"), of_image);
  const Eigen::Matrix3d of_model = Eigen::Matrix3d::Identity();  // OpenSim's
  EXPECT_EQ(DirectionsOfAxes("ASR"), of_model);
  EXPECT_EQ(DirectionsOfAxes("PIL"), Eigen::Matrix3d(-of_model));
}

}  // namespace
}  // namespace musclewarp
