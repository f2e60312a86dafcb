// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/site_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "musclewarp/mesh/transformed.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

// A knee that turns; bodies 1 and 2 are the thigh and the shank.
Model Knee() {
  return ReadModel(Written("leg.osim", Model4(Joint4("PinJoint", "knee"))));
}

// The postures of a straight path through sites.
std::vector<SitePosture> PosturesOf(const Model& model,
                                    const std::vector<Site>& sites) {
  std::vector<SitePosture> postures;
  const auto line_at = [&](double q) {
    const auto frames = BodyFrames(model, {q});
    Points line(static_cast<Eigen::Index>(sites.size()), 3);
    for (size_t i = 0; i < sites.size(); ++i) {
      line.row(static_cast<Eigen::Index>(i)) =
          (frames[sites[i].body] * sites[i].place.homogeneous())
              .head<3>()
              .transpose();
    }
    return line;
  };
  const auto length_at = [&](double q) {
    const Points line = line_at(q);
    double length = 0;
    for (Eigen::Index i = 1; i < line.rows(); ++i) {
      length += (line.row(i) - line.row(i - 1)).norm();
    }
    return length;
  };
  constexpr double kStep = 1e-5;
  for (double q = -0.2; q < 1.2; q += 0.1) {
    SitePosture posture;
    posture.values = {q};
    posture.line = line_at(q);
    posture.length = length_at(q);
    posture.arms = Eigen::VectorXd::Constant(
        1, (length_at(q - kStep) - length_at(q + kStep)) / (2 * kStep));
    postures.push_back(posture);
  }
  return postures;
}

TEST(SitePath, FollowsAPathThroughSites) {
  const Model model = Knee();
  const std::vector<Site> sites = {
      {1, {0, -50, 40}}, {1, {0, -380, 45}}, {2, {0, -40, 40}}};
  const SitePath path = FitSites(model, {1, 2}, {0}, PosturesOf(model, sites));
  EXPECT_LT(path.arm_median, kGoodArm);
  EXPECT_LT(path.length_largest, 2);
  EXPECT_EQ(path.sites.front().body, 1);
  EXPECT_EQ(path.sites.back().body, 2);
}

// Its errors are those of the sites that it has.
TEST(SitePath, SaysHowFarItIs) {
  const Model model = Knee();
  std::vector<SitePosture> postures =
      PosturesOf(model, {{1, {0, -50, 40}}, {2, {0, -40, 40}}});
  for (size_t i = 0; i < postures.size(); ++i) {
    // No path through sites has arms that go up and down by 30 mm.
    postures[i].arms[0] += i % 2 == 0 ? 30 : -30;
  }
  const SitePath path = FitSites(model, {1, 2}, {0}, postures);
  EXPECT_GT(path.arm_median, 10);
  EXPECT_GE(path.arm_largest, path.arm_median);
  EXPECT_GE(path.length_largest, path.length_mean);
}

}  // namespace
}  // namespace musclewarp
