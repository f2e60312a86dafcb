// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/bare_tendons.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/anatomy/image_directions.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const Eigen::Matrix3d kFrame = DirectionsOfAxes("ASR");

// A lower leg, forward, up and right being the axes: a tibia, a fibula and,
// 180 mm below the middle of the tibia, the bones of a foot. A belly lies
// behind the tibia, with a line from 100 mm above its middle to 80 below.
class BareTendons : public testing::Test {
 protected:
  explicit BareTendons(
      const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity())
      : turn_(turn) {
    AddBone("tibia", "tibia_r", MovedBy(Box(22, 340, 22), {0, 0, 0}));
    AddBone("fibula", "tibia_r", MovedBy(Box(12, 330, 12), {-18, -14, 29}));
    AddBone("talus", "foot_r", MovedBy(Box(50, 25, 30), {0, -185, 0}));
    AddBone("calcaneus", "foot_r", MovedBy(Box(70, 30, 30), {-25, -213, 3}));
    AddBone("metatarsal_1", "foot_r", MovedBy(Box(60, 14, 14), {80, -218, -8}));
    AddBone("metatarsal_5", "foot_r", MovedBy(Box(65, 12, 12), {55, -222, 40}));
    ActionLine line;
    line.name = "line_1";
    line.rest.resize(19, 3);
    for (int i = 0; i < 19; ++i) {
      line.rest.row(i) = Turned(Eigen::RowVector3d(-22, 100 - 10.0 * i, 5));
    }
    line.bodies.assign(19, "tibia_r");
    line.slides = true;
    lines_ = {line};
  }

  Eigen::RowVector3d Turned(const Eigen::RowVector3d& point) const {
    return point * turn_.transpose();
  }

  void AddBone(const std::string& name,
               const std::string& body,
               TriangleSoup mesh) {
    mesh.points = mesh.points * turn_.transpose();
    surroundings_.AddBone(name, body, mesh);
  }

  std::vector<BareTendon> Add(const std::string& muscle,
                              const std::vector<std::string>& end_bodies = {}) {
    SceneMuscle named;
    named.name = muscle;
    named.end_bodies = end_bodies;
    return AddBareTendons(named, surroundings_, kFrame, &lines_);
  }

  Eigen::RowVector3d End() const {
    return lines_[0].rest.row(lines_[0].rest.rows() - 1);
  }

  Eigen::Matrix3d turn_;
  Surroundings surroundings_;
  std::vector<ActionLine> lines_;
};

TEST_F(BareTendons, GoOnToTheBoneOnWhichTheNameEnds) {
  const Points belly = lines_[0].rest;
  const std::vector<BareTendon> tendons = Add("soleus_right");
  ASSERT_EQ(tendons.size(), 1u);
  EXPECT_FALSE(tendons[0].is_at_origin);
  EXPECT_EQ(tendons[0].body, "foot_r");
  EXPECT_EQ(tendons[0].bone, "calcaneus");
  EXPECT_EQ(tendons[0].landmark, "calcaneal_tuberosity");
  EXPECT_EQ(tendons[0].evidence, LandmarkEvidence::kFound);
  const ActionLine& line = lines_[0];
  // But for a tenth of its length, which may lead to the edge of a cut.
  EXPECT_EQ(line.rest.topRows(17), belly.topRows(17));
  EXPECT_EQ(line.bodies.front(), "tibia_r");
  EXPECT_EQ(line.bodies.back(), "foot_r");
  EXPECT_EQ(static_cast<Eigen::Index>(line.bodies.size()), line.rest.rows());
  // The back of the heel.
  EXPECT_NEAR(End().x(), -60, 1);
  EXPECT_EQ(line.bare_begin, 0);
  // A straight way but for the corner of the heel.
  EXPECT_NEAR(line.bare_end, (End() - belly.row(18)).norm(), 5);
  EXPECT_NEAR(tendons[0].length, line.bare_end, 1e-9);
  EXPECT_THAT(BareTendonWarnings("soleus_right", tendons, 1),
              ElementsAre(HasSubstr("\"calcaneal tuberosity\" (found)")));
}

TEST_F(BareTendons, DoNotDependOnTheDirectionOfALine) {
  const ActionLine forward = lines_[0];
  Add("soleus");
  const Points expected = lines_[0].rest;
  lines_ = {forward};
  lines_[0].rest = Points(forward.rest.colwise().reverse());
  Add("soleus");
  EXPECT_EQ(Points(lines_[0].rest.colwise().reverse()), expected);
  EXPECT_GT(lines_[0].bare_begin, 0);
  EXPECT_EQ(lines_[0].bare_end, 0);
}

TEST_F(BareTendons, PassTheirPulleys) {
  // The peroneal tendon passes behind the fibula, at x = -24, not before it.
  const auto tendons = Add("peroneus longus");
  ASSERT_EQ(tendons.size(), 1u);
  EXPECT_EQ(tendons[0].bone, "metatarsal_1");
  for (const auto& point : lines_[0].rest.rowwise()) {
    if (point.y() > -140 || point.y() < -160) continue;
    EXPECT_LT(point.x(), -22);
  }
}

TEST_F(BareTendons, AreNoneWhereNothingIsMissedOrKnown) {
  const Points before = lines_[0].rest;
  EXPECT_THAT(Add("muscle_04"), IsEmpty());
  EXPECT_THAT(Add("popliteus"), IsEmpty());  // without a femur
  lines_[0].bodies.back() = "foot_r";
  EXPECT_THAT(Add("soleus"), IsEmpty());
  EXPECT_EQ(lines_[0].rest, before);
}

TEST_F(BareTendons, GoToTheBodiesThatTheSceneNames) {
  lines_[0].bodies.back() = "foot_r";
  const auto tendons = Add("muscle_04", {"tibia_r", "foot_r"});
  ASSERT_EQ(tendons.size(), 1u);
  EXPECT_EQ(tendons[0].body, "foot_r");
  EXPECT_EQ(tendons[0].landmark, "");
  EXPECT_EQ(tendons[0].evidence, LandmarkEvidence::kGuessed);
}

class TurnedBareTendons : public BareTendons {
 protected:
  TurnedBareTendons()
      : BareTendons(
            Eigen::AngleAxisd(2.2, Eigen::Vector3d(1, 2, -0.4).normalized())
                .toRotationMatrix()) {}
};

TEST_F(TurnedBareTendons, AreTurned) {
  Add("soleus_right");
  const Eigen::RowVector3d end = End() * turn_;
  EXPECT_NEAR(end.x(), -60, 1);
}

}  // namespace
}  // namespace musclewarp
