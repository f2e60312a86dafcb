// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/linear_push.h"

#include <gtest/gtest.h>

#include <random>

#include "musclewarp/solver/bone_touches.h"

namespace musclewarp {
namespace {

BonePush Bone() {
  BonePush push;
  push.stiffness = 40;
  push.options.onset = 1;
  return push;
}

// A positive semidefinite response of less than full rank, as samples that lie
// close to each other have it.
Eigen::MatrixXd Response(int count, std::mt19937* random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd factor(count, count / 2);
  for (double& entry : factor.reshaped()) entry = normal(*random);
  return factor * factor.transpose() / count;
}

// At the least energy each force is what the bone exerts at what is left of the
// lack.
TEST(LinearPushForces, AreThoseOfTheBone) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const BonePush push = Bone();
  for (int round = 0; round < 20; ++round) {
    const Eigen::MatrixXd response = Response(30, &random);
    Eigen::VectorXd lack(30);
    for (double& entry : lack) entry = 3 * normal(random);
    // Wherever the search starts.
    for (const double start : {0.0, 1.0, 100.0}) {
      const Eigen::VectorXd forces = LinearPushForces(
          push, response, lack, Eigen::VectorXd::Constant(30, start));
      const Eigen::VectorXd left = lack - response * forces;
      for (int a = 0; a < 30; ++a) {
        EXPECT_NEAR(forces[a], ForceAt(push, left[a]).force, 1e-3);
      }
    }
  }
}

TEST(LinearPushForces, AreNoneWhereNothingLacks) {
  std::mt19937 random(2);
  const Eigen::MatrixXd response = Response(10, &random);
  EXPECT_TRUE(LinearPushForces(Bone(),
                               response,
                               Eigen::VectorXd::Constant(10, -1),
                               Eigen::VectorXd::Zero(10))
                  .isZero(0));
  EXPECT_EQ(LinearPushForces(Bone(), {}, {}, {}).size(), 0);
}

// Laws of the force: it is the slope of the energy, and the stiffness that of
// the force, on both sides of the onset.
TEST(ForceAt, HasTheSlopesOfTheEnergy) {
  const BonePush push = Bone();
  constexpr double kStep = 1e-5;  // mm
  for (const double lack : {0.3, 0.999, 1.001, 4.0}) {
    const BoneForce here = ForceAt(push, lack);
    const BoneForce before = ForceAt(push, lack - kStep);
    const BoneForce after = ForceAt(push, lack + kStep);
    EXPECT_NEAR(here.force, (after.energy - before.energy) / (2 * kStep), 1e-5);
    EXPECT_NEAR(
        here.stiffness, (after.force - before.force) / (2 * kStep), 1e-3);
  }
  EXPECT_EQ(ForceAt(push, 0).force, 0);
  EXPECT_EQ(ForceAt(push, -1).energy, 0);
}

}  // namespace
}  // namespace musclewarp
