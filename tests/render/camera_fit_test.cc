// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/camera_fit.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace musclewarp {
namespace {

const View kAnterior = {-Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()};

PictureMesh BoxAt(double x, bool fit) {
  PictureMesh mesh;
  mesh.surface = Box(2, 4, 6);
  mesh.surface.points.col(0).array() += x;
  mesh.fit = fit;
  return mesh;
}

TEST(CameraFit, HoldsTheHeightOrTheWidthOfAllPanels) {
  const std::vector<PicturePanel> panels = {{"", {BoxAt(0, true)}},
                                            {"", {BoxAt(10, true)}}};
  // 12 wide, 6 high, about (5, 0, 0).
  const CameraFit square = FitCamera(panels, kAnterior, 1);
  EXPECT_GE(square.half_height, 6);
  EXPECT_LT(square.half_height, 6 * 1.1);
  const CameraFit wide = FitCamera(panels, kAnterior, 4);
  EXPECT_GE(wide.half_height, 3);
  EXPECT_LT(wide.half_height, 3 * 1.1);
  // Halves and sums of small integers.
  EXPECT_LT((wide.center - Eigen::Vector3d(5, 0, 0)).norm(), 1e-12);
}

TEST(CameraFit, MeshesThatNeedNotFitAreStillReachedInDepth) {
  PictureMesh behind = BoxAt(50, false);
  behind.surface.points.col(1).array() += 100;
  const CameraFit alone = FitCamera({{"", {BoxAt(0, true)}}}, kAnterior, 1);
  const CameraFit both =
      FitCamera({{"", {BoxAt(0, true), behind}}}, kAnterior, 1);
  EXPECT_EQ(alone.half_height, both.half_height);
  EXPECT_EQ(alone.center, both.center);
  EXPECT_GT(both.depth, 102);
}

TEST(CameraFit, ASinglePointHasAPicture) {
  PictureMesh point;
  point.surface.points = Points::Ones(3, 3);
  point.surface.triangles.resize(1, 3);
  point.surface.triangles << 0, 1, 2;
  const CameraFit fit = FitCamera({{"", {point}}}, kAnterior, 1);
  EXPECT_GT(fit.half_height, 0);
  EXPECT_GT(fit.depth, 0);
}

}  // namespace
}  // namespace musclewarp
