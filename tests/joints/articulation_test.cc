// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/articulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "joints/made_leg.h"
#include "musclewarp/base/output_file.h"
#include "musclewarp/joints/articulated_model.h"
#include "musclewarp/joints/joints_file.h"
#include "musclewarp/opensim/kinematics.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

const FoundJoint& JointOf(const Articulation& articulation, JointKind kind) {
  return *std::find_if(articulation.joints.begin(),
                       articulation.joints.end(),
                       [&](auto& joint) { return joint.kind == kind; });
}

TEST(Articulate, FindsTheJointsOfALegWhicheverSideItIsOn) {
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const MadeLeg leg = LegOf(side);
    const Articulation articulation = Articulate(leg.bones, {});
    ASSERT_EQ(articulation.joints.size(), 2u);
    const FoundJoint& hip = JointOf(articulation, JointKind::kHip);
    const FoundJoint& knee = JointOf(articulation, JointKind::kKnee);
    EXPECT_EQ(hip.side, side);
    EXPECT_TRUE(hip.IsFound());
    EXPECT_EQ(knee.verdict.quality, JointQuality::kGood);
    // As the fits of these bones have it (sphere_fit_test, knee_test).
    EXPECT_LT((hip.center - leg.femur.head).norm(), 0.2);
    EXPECT_LT(OffsetFrom(leg.femur.knee, knee.center).norm(), 0.2);
    // The axis of the knee points to the right of the body.
    EXPECT_LT(knee.parent_axes.col(2).dot(leg.femur.left), -0.9);
    EXPECT_EQ(hip.child, knee.parent);
    for (const Bone& bone : articulation.bones) {
      if (bone.kind == BoneKind::kPelvis) continue;
      EXPECT_EQ(bone.side, side);
    }
  }
}

TEST(Articulate, RefusesAMirroredFemur) {
  MadeLeg leg = LegOf(Side::kRight);
  leg.bones[0].name = "femur_l";
  leg.bones[0].side = Side::kLeft;
  ExpectInputError(
      [&] { Articulate(leg.bones, {}); },
      {"femur_l", "shape of a right femur", "named left", "mirrored"});
}

TEST(Articulate, RefusesBonesWithoutJoints) {
  MadeLeg leg = LegOf(Side::kRight);
  leg.bones.resize(1);
  ExpectInputError([&] { Articulate(leg.bones, {}); },
                   {"none has its bones", "femur"});
  ArticulationOptions options;
  options.joints = {JointKind::kElbow};
  ExpectInputError([&] { Articulate(LegOf(Side::kRight).bones, options); },
                   {"joint elbow", "lacks its bones"});
}

// The head alone tells a hip, and nothing of it a knee.
TEST(Articulate, FindsNoKneeOnTheUpperPartOfAFemur) {
  MadeLeg leg = LegOf(Side::kRight);
  TriangleSoup& femur = leg.bones[0].mesh;
  const double middle = (leg.femur.head.z() + leg.femur.knee.point.z()) / 2;
  std::vector<bool> keep(femur.triangles.rows());
  for (int f = 0; f < femur.triangles.rows(); ++f) {
    keep[f] = femur.points(femur.triangles(f, 0), 2) > middle;
  }
  KeepTriangles(keep, &femur.triangles);
  // Neither half a femur nor one hip bone tells its side.
  ArticulationOptions options;
  options.side = Side::kRight;
  const Articulation articulation = Articulate(leg.bones, options);
  EXPECT_TRUE(JointOf(articulation, JointKind::kHip).IsFound());
  const FoundJoint& knee = JointOf(articulation, JointKind::kKnee);
  EXPECT_FALSE(knee.IsFound());
  EXPECT_FALSE(knee.verdict.reasons.empty());
  // The tibia stays fixed to the femur.
  const bool is_fixed = std::any_of(
      articulation.welds.begin(), articulation.welds.end(), [](auto& weld) {
        return weld.parent == "femur_r" && weld.child == "tibia_r";
      });
  EXPECT_TRUE(is_fixed);
}

TEST(Articulate, TakesJointsThatAreGiven) {
  const MadeLeg leg = LegOf(Side::kRight);
  ArticulationOptions options;
  FoundJoint given;
  given.kind = JointKind::kKnee;
  given.side = Side::kRight;
  given.center = {1, 2, 3};
  options.given = {given};
  const Articulation articulation = Articulate(leg.bones, options);
  const FoundJoint& knee = JointOf(articulation, JointKind::kKnee);
  EXPECT_TRUE(knee.is_given);
  EXPECT_EQ(knee.center, given.center);
  EXPECT_EQ(knee.parent, "femur_r");
}

TEST(JointsFile, GivesBackTheJointsThatWereWritten) {
  const Articulation articulation = Articulate(LegOf(Side::kRight).bones, {});
  const std::string path = TestTempDir() + "/joints.json";
  WriteTextAtomically(path, JointsJson(articulation, "LPS").dump());
  const std::vector<FoundJoint> read = ReadJoints(path);
  ASSERT_EQ(read.size(), articulation.joints.size());
  for (size_t i = 0; i < read.size(); ++i) {
    const FoundJoint& written = articulation.joints[i];
    EXPECT_EQ(read[i].name(), written.name());
    EXPECT_EQ(read[i].center, written.center);
    // Up to making them a rotation again.
    EXPECT_LT((read[i].parent_axes - written.parent_axes).norm(), 1e-14);
    EXPECT_LT((read[i].child_axes - written.child_axes).norm(), 1e-14);
  }
}

TEST(JointsFile, RefusesWhatIsNoJoint) {
  const std::string path = TestTempDir() + "/joints.json";
  const auto read = [&](const std::string& joint) {
    WriteTextAtomically(path, "{\"joints\": [" + joint + "]}");
    return [&] { ReadJoints(path); };
  };
  ExpectInputError(read(R"({"name": "hipp_r"})"),
                   {"joints[0].name", "which is no joint", "hip_r"});
  ExpectInputError(read(R"({"name": "hip_r"})"), {"center_mm"});
  ExpectInputError(read(R"({"name": "hip_r", "center_mm": [0, 0, 0],
               "parent_axes": [[1, 0, 0], [0, 1, 0], [0, 0, -1]]})"),
                   {"joints[0].parent_axes", "is no rotation"});
  ExpectInputError(
      read(R"({"name": "knee_r", "center_mm": [0, 0, 0], "axis": [0, 0, 0]})"),
      {"joints[0].axis", "is zero"});
}

// The model that is written, read by the reader of models.
class ModelOfLeg : public ::testing::Test {
 protected:
  ModelOfLeg() : articulation_(Articulate(LegOf(Side::kLeft).bones, {})) {
    const std::string path = TestTempDir() + "/model.osim";
    WriteTextAtomically(path, ArticulatedModelText(articulation_, "leg"));
    model_ = ReadModel(path);
  }

  Articulation articulation_;
  Model model_;
};

TEST_F(ModelOfLeg, HasTheBodiesInThePoseOfTheScan) {
  EXPECT_TRUE(model_.warnings.empty());
  for (const Eigen::Matrix4d& frame :
       BodyFrames(model_, DefaultValues(model_))) {
    EXPECT_LT((frame - Eigen::Matrix4d::Identity()).cwiseAbs().maxCoeff(),
              1e-6);  // mm, as the reader is trusted to
  }
}

TEST_F(ModelOfLeg, TurnsTheTibiaAboutTheKnee) {
  CoordinateValues values = DefaultValues(model_);
  const FoundJoint& knee = JointOf(articulation_, JointKind::kKnee);
  const int coordinate = model_.FindCoordinate("knee_angle_l");
  ASSERT_GE(coordinate, 0);
  values[coordinate] += 0.5;
  const Eigen::Matrix4d moved =
      BodyFrames(model_, values)[model_.FindBody("tibia_l")];
  // Flexion turns the shank backwards: about the left of the body.
  const Eigen::Matrix3d expected =
      Eigen::AngleAxisd(0.5, -knee.parent_axes.col(2)).toRotationMatrix();
  EXPECT_LT((moved.topLeftCorner<3, 3>() - expected).norm(), 1e-12);
  const Eigen::Vector4d center = knee.center.homogeneous();
  EXPECT_LT((moved * center - center).norm(), 1e-6);  // mm
}

TEST_F(ModelOfLeg, NamesTheVerdictsOfItsJoints) {
  const std::string text = ArticulatedModelText(articulation_, "leg");
  EXPECT_THAT(text, AnyOf(HasSubstr("hip_l: good"), HasSubstr("hip_l: weak")));
}

TEST(BodyFixedAngles, GiveTheRotationBack) {
  for (int seed = 1; seed <= 20; ++seed) {
    const Eigen::Matrix3d rotation = RandomMotion(seed).rotation();
    const Eigen::Vector3d angles = BodyFixedAngles(rotation);
    const Eigen::Matrix3d back =
        (Eigen::AngleAxisd(angles[0], Eigen::Vector3d::UnitX()) *
         Eigen::AngleAxisd(angles[1], Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles[2], Eigen::Vector3d::UnitZ()))
            .toRotationMatrix();
    EXPECT_LT((back - rotation).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace musclewarp
