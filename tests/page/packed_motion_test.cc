// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/packed_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "page/packed_text.h"

namespace musclewarp {
namespace {

// Two shapes move, and in each frame one number by as much as `spike` (mm).
std::vector<Points> Motion(int points, int frames, double spike) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Points rest(points, 3), bend(points, 3);
  for (Eigen::Index i = 0; i < rest.size(); ++i) {
    rest.data()[i] = 100 * uniform(generator);
    bend.data()[i] = 10 * uniform(generator);
  }
  std::vector<Points> poses = {rest};
  for (int frame = 0; frame < frames; ++frame) {
    const double t = 3.0 * frame / frames;
    Points moved = rest + std::sin(t) * bend + (1 - std::cos(t)) * rest;
    const auto hit = std::uniform_int_distribution<Eigen::Index>(
        0, moved.size() - 1)(generator);
    moved.data()[hit] += spike * uniform(generator);
    poses.push_back(moved);
  }
  return poses;
}

struct Packed {
  PackedMotion motion;
  std::string numbers;
  double error = 0;  // the largest, by reading it again
};

Packed PackAndRead(const std::vector<Points>& poses, double tolerance) {
  std::vector<const Points*> pointers;
  for (const Points& pose : poses) pointers.push_back(&pose);
  PackedNumbers numbers;
  Packed packed;
  packed.motion = PackMotion(pointers, tolerance, &numbers);
  packed.numbers = numbers.Base64();
  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    const Points read = UnpackedPose(
        packed.numbers, packed.motion.json, static_cast<int>(pose));
    if (read.size() == 0) continue;
    packed.error =
        std::max(packed.error, (read - poses[pose]).cwiseAbs().maxCoeff());
  }
  return packed;
}

TEST(PackedMotion, IsWithinTheToleranceThatItIsGiven) {
  const std::vector<Points> poses = Motion(50, 40, 5);
  for (const double tolerance : {0.001, 0.02, 0.5, 20.0}) {
    const Packed packed = PackAndRead(poses, tolerance);
    EXPECT_LE(packed.error, tolerance * (1 + 1e-9));
    // What is told is what is there, but for rounding of the reader's sums.
    EXPECT_NEAR(packed.motion.max_error, packed.error, 1e-9);
  }
}

TEST(PackedMotion, FewShapesTakeFewModes) {
  const Packed packed = PackAndRead(Motion(500, 60, 0), 0.01);
  EXPECT_EQ(packed.motion.json["modes"], 2);
  // Where two modes rounded to half the tolerance add up to more than it.
  EXPECT_LE(packed.motion.json["corrections"]["count"], 2 * 0.01 * 1500 * 60);
}

TEST(PackedMotion, StillPointsTakeNone) {
  const Points rest = Motion(20, 0, 0)[0];
  const Packed packed = PackAndRead({rest, rest, rest}, 0.01);
  EXPECT_EQ(packed.motion.json["modes"], 0);
  EXPECT_EQ(packed.motion.json["corrections"]["count"], 0);
  EXPECT_LE(packed.error, 0.005 + 1e-9);  // half a step
}

TEST(PackedMotion, MayHaveNoPointsOrOnlyRest) {
  EXPECT_EQ(PackAndRead({Points(0, 3), Points(0, 3)}, 0.01).error, 0);
  EXPECT_LE(PackAndRead({Motion(20, 0, 0)[0]}, 0.01).error, 0.005 + 1e-9);
}

}  // namespace
}  // namespace musclewarp
