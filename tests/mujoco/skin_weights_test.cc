// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/skin_weights.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <vector>

#include "musclewarp/base/random_draws.h"
#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

using Motions = std::vector<std::vector<Eigen::Matrix4d>>;

// Rounding of least squares of coordinates of 100 mm.
constexpr double kSkinRounding = 1e-6;

Points DrawPoints(int count, RandomDraws* draws) {
  Points points(count, 3);
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) points(i, k) = draws->Uniform(-50, 50);
  }
  return points;
}

Motions DrawMotions(int frames, int bones, RandomDraws* draws) {
  Motions motions(frames);
  for (auto& of_frame : motions) {
    for (int b = 0; b < bones; ++b) {
      Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
      const double angle = draws->Uniform(-1, 1);
      motion.topLeftCorner<3, 3>() =
          Eigen::AngleAxisd(angle, draws->Direction()).matrix();
      motion.topRightCorner<3, 1>() = 10 * draws->Direction();
      of_frame.push_back(motion);
    }
  }
  return motions;
}

std::vector<Points> Skinned(const Points& rest,
                            const Eigen::MatrixXd& weights,
                            const Motions& motions) {
  std::vector<Points> frames;
  for (const auto& of_frame : motions) {
    Points& frame = frames.emplace_back(Points::Zero(rest.rows(), 3));
    for (size_t b = 0; b < of_frame.size(); ++b) {
      frame += weights.col(b).asDiagonal() * Transformed(rest, of_frame[b]);
    }
  }
  return frames;
}

TEST(SkinWeights, FindThoseOfASkin) {
  RandomDraws draws(1);
  const Points rest = DrawPoints(40, &draws);
  const Motions motions = DrawMotions(12, 3, &draws);
  Eigen::MatrixXd weights(40, 3);
  for (int v = 0; v < 40; ++v) {
    // Some vertices follow one bone alone.
    for (int b = 0; b < 3; ++b) {
      weights(v, b) = v < 10 ? (b == v % 3 ? 1 : 0) : draws.Uniform(0, 1);
    }
    weights.row(v) /= weights.row(v).sum();
  }
  const SkinWeights skin =
      FitSkin(rest, Skinned(rest, weights, motions), motions);
  EXPECT_LT((skin.weights - weights).cwiseAbs().maxCoeff(), kSkinRounding);
  EXPECT_LT((skin.places - rest).cwiseAbs().maxCoeff(), kSkinRounding);
  EXPECT_LT(skin.largest_distance, kSkinRounding);
}

TEST(SkinWeights, AreFromZeroToOneWithTheSumOne) {
  RandomDraws draws(2);
  const Points rest = DrawPoints(30, &draws);
  const Motions motions = DrawMotions(8, 4, &draws);
  std::vector<Points> frames;
  for (int f = 0; f < 8; ++f) frames.push_back(DrawPoints(30, &draws));
  const SkinWeights skin = FitSkin(rest, frames, motions);
  EXPECT_GE(skin.weights.minCoeff(), 0);
  EXPECT_LT((skin.weights.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-12);
  EXPECT_LT(skin.mean_distance, skin.largest_distance);
}

// Law: what moves everything as one has no part in it.
TEST(SkinWeights, OfOneBoneFollowIt) {
  RandomDraws draws(3);
  const Points rest = DrawPoints(5, &draws);
  const Motions motions = DrawMotions(4, 1, &draws);
  const SkinWeights skin = FitSkin(
      rest, Skinned(rest, Eigen::MatrixXd::Ones(5, 1), motions), motions);
  EXPECT_TRUE(skin.weights.isOnes());
  EXPECT_LT(skin.largest_distance, kSkinRounding);
}

}  // namespace
}  // namespace musclewarp
