// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/patella_joint.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "joints/made_leg.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/joints/articulated_model.h"
#include "musclewarp/joints/articulation.h"
#include "musclewarp/joints/joints_file.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/opensim/kinematics.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

class PatellaOfSide : public ::testing::TestWithParam<Side> {
 protected:
  PatellaOfSide()
      : articulation_(Articulate(LegWithPatella(GetParam()), {})),
        suffix_(SuffixOf(GetParam())) {
    path_ = TestTempDir() + "/model.osim";
    WriteTextAtomically(path_, ArticulatedModelText(articulation_, "leg"));
    model_ = ReadModel(path_);
  }

  const FoundJoint& Patella() const {
    return *std::find_if(articulation_.joints.begin(),
                         articulation_.joints.end(),
                         [](auto& j) { return j.kind == JointKind::kPatella; });
  }

  const Articulation articulation_;
  const std::string suffix_;
  std::string path_;
  Model model_;
};

TEST_P(PatellaOfSide, KeepsItsDistanceFromTheTuberosity) {
  ASSERT_TRUE(Patella().IsFound());
  const TriangleSoup& patella = articulation_.bones[3].mesh;
  const TriangleSoup& tibia = articulation_.bones[1].mesh;
  int lowest = 0, front = 0;
  patella.points.col(2).minCoeff(&lowest);
  tibia.points.col(1).minCoeff(&front);
  // The shaft of the made tibia is upright, so that all of its front is
  // tuberosity, as seen along the axis; the joint takes one place of it. That
  // the distance stays tells which: it is looked for along the front.
  const Eigen::Vector3d tip = patella.points.row(lowest).transpose();
  const int knee = model_.FindCoordinate("knee_angle" + suffix_);
  double best = 1e9;
  for (double below = 30; below <= 80; below += 0.5) {
    Eigen::Vector3d tuberosity = tibia.points.row(front).transpose();
    tuberosity.z() = -below;
    double least = 1e9, most = 0;
    for (double angle = 0; angle <= 1.5; angle += 0.1) {
      CoordinateValues values = DefaultValues(model_);
      values[knee] += angle;
      ApplyCouplers(model_, &values);
      const auto frames = BodyFrames(model_, values);
      const Eigen::Vector4d a =
          frames[model_.FindBody("patella" + suffix_)] * tip.homogeneous();
      const Eigen::Vector4d b =
          frames[model_.FindBody("tibia" + suffix_)] * tuberosity.homogeneous();
      const double distance = (a - b).norm();
      least = std::min(least, distance);
      most = std::max(most, distance);
    }
    best = std::min(best, most - least);
  }
  // The function is linear over 5 degrees, on which the path bends by less than
  // 0.01 mm. The place is known to half a step of the search, which changes the
  // length by some tenths.
  EXPECT_LT(best, 0.5);  // mm; a patella that stands still is off by 60
}

TEST_P(PatellaOfSide, GoesDownAsTheKneeBends) {
  const JointCoupling& coupling = Patella().coupling;
  EXPECT_EQ(coupling.coordinate, "knee_angle" + suffix_);
  ASSERT_GT(coupling.at.size(), 20u);
  for (size_t i = 1; i < coupling.at.size(); ++i) {
    EXPECT_GT(coupling.at[i], coupling.at[i - 1]);
    EXPECT_GT(coupling.values[i], coupling.values[i - 1]);
  }
}

TEST_P(PatellaOfSide, IsReadBackWithItsCoupling) {
  const std::string file = TestTempDir() + "/joints.json";
  WriteTextAtomically(file, JointsJson(articulation_, "LPS").dump());
  for (const FoundJoint& read : ReadJoints(file)) {
    if (read.kind != JointKind::kPatella) continue;
    const JointCoupling& written = Patella().coupling;
    EXPECT_EQ(read.coupling.coordinate, written.coordinate);
    ASSERT_EQ(read.coupling.at.size(), written.at.size());
    for (size_t i = 0; i < written.at.size(); ++i) {
      // Degrees and back, to rounding.
      EXPECT_NEAR(read.coupling.at[i], written.at[i], 1e-14);
      EXPECT_NEAR(read.coupling.values[i], written.values[i], 1e-14);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Both,
                         PatellaOfSide,
                         ::testing::Values(Side::kRight, Side::kLeft),
                         [](const auto& side) { return ToString(side.param); });

}  // namespace
}  // namespace musclewarp
