// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/label_surface.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "support/input_errors.h"
#include "support/made_images.h"

namespace musclewarp {
namespace {

// The search for the level ends at 2e-4.
constexpr double kVolumeAccuracyOfMesh = 2.5e-4;

LabelImage ReadAs(const MadeImage& made) {
  LabelImage image;
  image.grid.size = made.size;
  image.grid.world_from_index = made.lps_from_index;
  image.labels.assign(made.labels.begin(), made.labels.end());
  return image;
}

LabelSurface SurfaceOf(const MadeImage& made, double edge_length) {
  const LabelImage image = ReadAs(made);
  const LabelRegion region =
      PiecesOfLabel(image, 1, BoxesOfLabels(image).at(1)).regions[0];
  return SurfaceOfRegion("label 1", region, image.grid, edge_length);
}

// A ball of label 1 in the middle of an image.
MadeImage BallImage(const Eigen::Array3i& size,
                    const Eigen::Matrix4d& steps,
                    double radius) {
  const Eigen::Vector4d middle(
      (size[0] - 1) / 2.0, (size[1] - 1) / 2.0, (size[2] - 1) / 2.0, 1);
  const Eigen::Vector3d centre = (steps * middle).head<3>();
  return MakeImage(size, steps, [&](const Eigen::Vector3d& place) {
    return (place - centre).norm() < radius ? 1 : 0;
  });
}

void ExpectClosedWithVolume(const TriangleSoup& mesh, double volume) {
  EXPECT_TRUE(CountDefects(mesh).IsClean());
  EXPECT_NEAR(SignedVolume(mesh.points, mesh.triangles) / volume,
              1,
              kVolumeAccuracyOfMesh);
}

// Smoothing does not shrink: the volume is that of the voxels for balls of any
// size, and the surface is where the ball ends, to a part of a voxel.
TEST(LabelSurface, ABallKeepsItsVolumeCentreAndRadius) {
  constexpr double kPartOfVoxel = 0.5;
  for (const double radius : {3.0, 6.0, 12.0}) {
    const MadeImage image =
        BallImage({30, 30, 30}, TurnedSteps({1, 1, 1}, {5, 6, 7}), radius);
    const LabelSurface surface = SurfaceOf(image, 2);
    ExpectClosedWithVolume(surface.mesh, VoxelVolumeOf(image, 1));
    const Eigen::Vector3d centre =
        (image.lps_from_index * Eigen::Vector4d(14.5, 14.5, 14.5, 1)).head<3>();
    const Eigen::VectorXd radii =
        (surface.mesh.points.rowwise() - centre.transpose()).rowwise().norm();
    EXPECT_LT((radii.array() - radius).abs().maxCoeff(), kPartOfVoxel);
  }
}

TEST(LabelSurface, MillimetresComeFromTheStepsOfTheImage) {
  const MadeImage image =
      BallImage({50, 30, 12}, TurnedSteps({0.6, 1, 3}, {-100, 50, 900}), 12);
  const LabelSurface surface = SurfaceOf(image, 2);
  ExpectClosedWithVolume(surface.mesh, VoxelVolumeOf(image, 1));
  const Eigen::Vector3d centre =
      (image.lps_from_index * Eigen::Vector4d(24.5, 14.5, 5.5, 1)).head<3>();
  // A part of the smallest edge of a voxel.
  EXPECT_LT((surface.mesh.points.colwise().mean().transpose() - centre).norm(),
            0.3);
}

TEST(LabelSurface, IsOutwardInALeftHandedImage) {
  Eigen::Matrix4d steps = TurnedSteps({1, 1, 1}, {0, 0, 0});
  steps.col(2) *= -1;
  const MadeImage image = BallImage({16, 16, 16}, steps, 6);
  ExpectClosedWithVolume(SurfaceOf(image, 2).mesh, VoxelVolumeOf(image, 1));
}

TEST(LabelSurface, IsClosedAtTheBorderOfTheImage) {
  const MadeImage image = MakeImage({10, 10, 10},
                                    Eigen::Matrix4d::Identity(),
                                    [](const Eigen::Vector3d&) { return 1; });
  const LabelSurface surface = SurfaceOf(image, 1.5);
  ExpectClosedWithVolume(surface.mesh, 1000);
  // The border is half a voxel beyond the centres of the last voxels.
  EXPECT_NEAR(surface.mesh.points.minCoeff(), -0.5, 0.2);
  EXPECT_NEAR(surface.mesh.points.maxCoeff(), 9.5, 0.2);
}

// Noise is the worst of labels.
TEST(LabelSurface, IsClosedForARaggedLabel) {
  unsigned state = 1;
  const MadeImage image = MakeImage(
      {20, 20, 20},
      Eigen::Matrix4d::Identity(),
      [&](const Eigen::Vector3d& place) {
        state = state * 1664525u + 1013904223u;
        const double noise = 3.0 * (state >> 8) / (1u << 24);
        return (place.array() - 9.5).matrix().norm() + noise < 8 ? 1 : 0;
      });
  const LabelSurface surface = SurfaceOf(image, 2);
  EXPECT_TRUE(CountDefects(surface.mesh).IsClean());
  EXPECT_GT(surface.volume, 0);
}

// A plate of one voxel is as thin as it gets.
TEST(LabelSurface, AThinPlateKeepsItsVolume) {
  const MadeImage image =
      MakeImage({40, 30, 5},
                Eigen::Matrix4d::Identity(),
                [](const Eigen::Vector3d& place) {
                  return place[2] == 2 && place[0] > 3 && place[0] < 36 &&
                                 place[1] > 3 && place[1] < 26
                             ? 1
                             : 0;
                });
  const LabelSurface surface = SurfaceOf(image, 1);
  EXPECT_TRUE(CountDefects(surface.mesh).IsClean());
  EXPECT_LT(surface.lost_volume, 0.02 * VoxelVolumeOf(image, 1));
}

// A belly of 12 voxels with a tendon of one or two voxels, as at the spacing of
// common segmentations, and a rim that smoothing may take off.
TEST(LabelSurface, ATendonOfOneOrTwoVoxelsIsKeptAndDoesNotCrossItself) {
  for (const int thickness : {1, 2}) {
    const MadeImage image =
        MakeImage({24, 24, 80},
                  Eigen::Matrix4d::Identity(),
                  [&](const Eigen::Vector3d& place) {
                    const double x = place[0] - 12, y = place[1] - 12;
                    const bool is_belly =
                        place[2] > 4 && place[2] < 30 && x * x + y * y < 36;
                    // It bends by a voxel now and then.
                    const double bend = std::floor(place[2] / 20);
                    const bool is_tendon =
                        place[2] >= 30 && place[2] < 74 && x >= bend &&
                        x < bend + thickness + 1 && y >= 0 && y < thickness;
                    return is_belly || is_tendon ? 1 : 0;
                  });
    const LabelSurface surface = SurfaceOf(image, 2);
    EXPECT_TRUE(CountDefects(surface.mesh).IsClean());
    EXPECT_TRUE(SelfIntersections(surface.mesh).empty());
    // It ends at 73.5; the tip of one voxel is rounded off.
    EXPECT_GT(surface.mesh.points.col(2).maxCoeff(), 71.5) << thickness;
    EXPECT_NEAR(surface.volume / VoxelVolumeOf(image, 1), 1, 0.01);
  }
}

TEST(LabelSurface, RefusesALabelWithoutABody) {
  const auto refused = [](const Eigen::Array3i& size,
                          const std::vector<std::string>& words) {
    const MadeImage image = MakeImage(size,
                                      Eigen::Matrix4d::Identity(),
                                      [](const Eigen::Vector3d&) { return 1; });
    ExpectInputError([&] { SurfaceOf(image, 1); }, words);
  };
  refused({3, 3, 7}, {"label 1: has 63 voxels", "at least 64", "remove it"});
}

}  // namespace
}  // namespace musclewarp
