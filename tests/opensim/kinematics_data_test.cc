// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "musclewarp/base/angles.h"
#include "musclewarp/opensim/coordinate_motion.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/rest_pose.h"
#include "musclewarp/scene/poses_file.h"
#include "support/data_root.h"

namespace musclewarp {
namespace {

using Eigen::Vector3d;

class KinematicsData : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = DataRoot();
    if (root_.empty()) GTEST_SKIP() << kNoDataRoot;
  }
  std::string root_;
};

// poses.json gives the femur in the frame of the pelvis, rounded to 8 digits,
// and the points of the paths to 4.
constexpr double kFemur = 1e-6;
constexpr double kPathPoints = 0.51e-4;

TEST_F(KinematicsData, LhdlAgreesWithItsPoses) {
  const Model model = ReadModel(root_ + "/lhdl_hip/LHDL_hip_r.osim");
  const int pelvis = model.FindBody("pelvis");
  const int femur = model.FindBody("femur_r");
  const int flexion = model.FindCoordinate("hip_flexion_r");
  const PosesFile file =
      ReadPosesFile(root_ + "/lhdl_hip/poses.json", {{"femur", {"femur_r"}}});
  ASSERT_EQ(file.poses.size(), 4u);
  for (const ScenePose& pose : file.poses) {
    CoordinateValues values = DefaultValues(model);
    values[flexion] = RadiansOf(pose.coordinates.at("hip_flexion_r_deg"));
    const auto frames = BodyFrames(model, values);
    const Eigen::Matrix4d pelvis_from_ground =
        Eigen::Isometry3d(frames[pelvis]).inverse().matrix();
    EXPECT_LT((pelvis_from_ground * frames[femur] - pose.bodies.at("femur_r"))
                  .cwiseAbs()
                  .maxCoeff(),
              kFemur)
        << pose.name;
    for (const ModelMuscle& muscle : model.muscles) {
      const Points& target = pose.lines.at(muscle.name);
      Eigen::Index row = 0;
      for (const PathPoint& point : muscle.path) {
        if (point.condition >= 0) continue;  // left out there
        const Vector3d here = (pelvis_from_ground * frames[point.body] *
                               LocationOnBody(point, values).homogeneous())
                                  .head<3>();
        EXPECT_LT((here - target.row(row++).transpose()).cwiseAbs().maxCoeff(),
                  kPathPoints)
            << muscle.name;
      }
      EXPECT_EQ(row, target.rows()) << muscle.name;
    }
  }
}

// README: the specimen lay about 7 degrees away from the zero pose.
TEST_F(KinematicsData, LhdlRestPoseIsFound) {
  const Model model = ReadModel(root_ + "/lhdl_hip/LHDL_hip_r.osim");
  const CoincidentPose pose = FindCoincidentPose(
      model, {model.FindBody("pelvis"), model.FindBody("femur_r")});
  // The joint's places on the two bodies differ by 0.001 mm in the file.
  EXPECT_LT(pose.distance, 1.1e-3);
  EXPECT_LT(pose.angle, 1e-4);
  double squared = 0;
  for (const double value : pose.values) squared += value * value;
  EXPECT_NEAR(DegreesOf(std::sqrt(squared)), 7, 0.5);
}

TEST_F(KinematicsData, LhdlMotionsHaveTheRowsOfTheirReadme) {
  const Model model = ReadModel(root_ + "/lhdl_hip/LHDL_hip_r.osim");
  const std::string folder = root_ + "/lhdl_hip/motions/";
  const struct {
    const char* file;
    size_t rows;
    size_t warnings;  // idle columns; and a wrong number of rows
  } kMotions[] = {{"hip_flexion.mot", 36, 2},
                  {"hip_adduction.mot", 41, 1},
                  {"hip_rotation.mot", 31, 1}};
  for (const auto& expected : kMotions) {
    const std::string path = folder + expected.file;
    const auto motion = MotionOf(model, ReadStorageTable(path), path);
    EXPECT_EQ(motion.times.size(), expected.rows) << path;
    EXPECT_EQ(motion.warnings.size(), expected.warnings) << path;
    EXPECT_EQ(motion.moving.size(), 1u) << path;
  }
}

// gait2392, right leg, worked out by hand from the file. All mm:
//   hip_r sits at (-70.7, -66.1, 83.5) of the pelvis and at the femur's origin;
//   hip_flexion_r turns about z. knee_r turns about z by knee_angle_r and moves
//   by two splines; at the knot -0.349066 rad of both they give x -1, y -397.6.
//   rect_fem_r: from (-29.5, -31.1, 96.8) on the pelvis, over (33.4, -403, 1.9)
//   on the femur while the knee is between -2.61799 and -1.45997 rad, to a
//   point of the tibia that moves with the knee: at the same knot
//   (48.391, 23.4197, 1.4).
class Gait2392 : public KinematicsData {
 protected:
  void SetUp() override {
    KinematicsData::SetUp();
    if (IsSkipped()) return;
    model_ = ReadModel(root_ + "/opensim/gait2392_thelen2003muscle.osim");
    values_ = DefaultValues(model_);
    Set("hip_flexion_r", 0);
    Set("hip_adduction_r", 0);
    Set("hip_rotation_r", 0);
    Set("knee_angle_r", 0);
  }
  void Set(const std::string& coordinate, double value) {
    values_[model_.FindCoordinate(coordinate)] = value;
  }
  Vector3d InPelvis(const std::string& body, const Vector3d& point) const {
    const auto frames = BodyFrames(model_, values_);
    return (Eigen::Isometry3d(frames[model_.FindBody("pelvis")])
                .inverse()
                .matrix() *
            frames[model_.FindBody(body)] * point.homogeneous())
        .head<3>();
  }

  static constexpr double kKnot = -0.349066;
  const Vector3d hip_{-70.7, -66.1, 83.5};
  const Vector3d knee_{-1, -397.6, 0};  // of the femur, at the knot
  // Sums of figures of the file, which has 4 digits of a mm.
  static constexpr double kExact = 1e-9;
  Model model_;
  CoordinateValues values_;
};

TEST_F(Gait2392, TheKneeMovesByItsSplines) {
  Set("knee_angle_r", kKnot);
  EXPECT_LT((InPelvis("tibia_r", Vector3d::Zero()) - (hip_ + knee_)).norm(),
            kExact);
  // A quarter turn of the hip takes (x, y) to (-y, x).
  Set("hip_flexion_r", M_PI / 2);
  EXPECT_LT(
      (InPelvis("tibia_r", Vector3d::Zero()) - (hip_ + Vector3d(397.6, -1, 0)))
          .norm(),
      kExact);
  // 10 mm along the tibia's x axis, which the knee has turned by the knot.
  const double angle = M_PI / 2 + kKnot;
  EXPECT_LT(
      (InPelvis("tibia_r", Vector3d(10, 0, 0)) -
       (hip_ +
        Vector3d(397.6 + 10 * std::cos(angle), -1 + 10 * std::sin(angle), 0)))
          .norm(),
      kExact);
}

TEST_F(Gait2392, MovingAndConditionalPointsMakeThePath) {
  const ModelMuscle& rectus = model_.muscles[model_.FindMuscle("rect_fem_r")];
  ASSERT_EQ(rectus.path.size(), 3u);
  Set("knee_angle_r", kKnot);
  const Vector3d on_tibia(48.391, 23.4197, 1.4);
  EXPECT_LT((LocationOnBody(rectus.path[2], values_) - on_tibia).norm(),
            kExact);
  EXPECT_FALSE(IsActive(rectus.path[1], values_));
  // By hand: cos 0.939692, sin -0.342020 of the knot give the tibia's point at
  // (52.4826, -392.1434, 1.4) of the femur, (-18.2174, -458.2434, 84.9) of the
  // pelvis; from (-29.5, -31.1, 96.8) that is sqrt(11.2826^2 + 427.1434^2 +
  // 11.9^2) = 427.4580.
  EXPECT_NEAR(
      PathLength(rectus, BodyFrames(model_, values_), values_), 427.4580, 1e-3);
  Set("knee_angle_r", -1.5);
  EXPECT_TRUE(IsActive(rectus.path[1], values_));
  Set("knee_angle_r", -1.4);
  EXPECT_FALSE(IsActive(rectus.path[1], values_));
}

TEST_F(Gait2392, HasAllMusclesAndNothingUnsupported) {
  EXPECT_EQ(model_.muscles.size(), 92u);
  for (size_t i = 0; i < model_.muscles.size(); ++i) {
    CheckMuscleIsSupported(model_, static_cast<int>(i));
  }
  EXPECT_EQ(model_.coordinates.size(), 23u);
  EXPECT_EQ(model_.bodies[model_.FindBody("tibia_r")].geometry.size(), 2u);
}

}  // namespace
}  // namespace musclewarp
