// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "support/muscles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "musclewarp/solver/gauss_newton.h"
#include "support/meshes.h"

namespace musclewarp {

SceneMuscle SpindleMuscle() {
  SceneMuscle muscle;
  muscle.name = "spindle";
  ActionLine middle;
  middle.name = "middle";
  middle.rest.resize(3, 3);
  middle.rest << 0, 0, -55, 1, 0, 0, 0, 0, 55;
  middle.bodies = {"pelvis", "pelvis", "femur"};
  ActionLine side;
  side.name = "side";
  side.rest.resize(2, 3);
  side.rest << 8, 2, -30, 8, 2, 35;
  side.bodies = {"pelvis", "femur"};
  muscle.lines = {middle, side};
  Attachment origin;
  origin.body = "pelvis";
  origin.points.resize(1, 3);
  origin.points << 0, 0, -60;
  origin.radius = 12;
  Attachment insertion = origin;
  insertion.body = "femur";
  insertion.points *= -1;
  muscle.attachments = {origin, insertion};
  return muscle;
}

std::vector<Points> SpindleFibres() {
  std::vector<Points> fibres;
  for (const double x : {-4.0, 0.0, 4.0}) {
    Points& fibre = fibres.emplace_back(9, 3);
    for (int i = 0; i < 9; ++i) {
      const double z = 12.5 * (i - 4);
      fibre.row(i) << x * (1 - z * z / 3600), 0, z;
    }
  }
  return fibres;
}

MuscleModelOptions NoAttachmentRows() {
  MuscleModelOptions options;
  options.attachment_weight = 0;
  return options;
}

MuscleModel SpindleModel(const MuscleModelOptions& options) {
  return PrepareMuscle(SpindleMuscle(),
                       Spindle(12, 60, 3),
                       Spindle(15, 66, 2),
                       {{}, SpindleFibres()},
                       options);
}

Points SolvedTightly(const MuscleModel& model, const MuscleTarget& target) {
  GaussNewtonOptions options;
  options.polish_threshold = 1e-10;
  options.volume_tolerance = 1e-12;
  Points coarse = UnconstrainedMinimizer(model, target);
  SolverSummary summary;
  SolveGaussNewton(model, target, options, &coarse, &summary);
  EXPECT_TRUE(summary.IsSolutionUsable()) << summary.FullReport();
  return coarse;
}

ScenePose FemurPose(const Eigen::Matrix3d& rotation,
                    const Eigen::Vector3d& translation) {
  ScenePose pose;
  pose.name = "femur";
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  transform.topLeftCorner<3, 3>() = rotation;
  transform.topRightCorner<3, 1>() = translation;
  pose.bodies["femur"] = transform;
  return pose;
}

ScenePose BentPose(double angle) {
  return FemurPose(
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix(),
      Eigen::Vector3d(3, 1, -2));
}

ScenePose RigidPose(const Eigen::Matrix3d& rotation,
                    const Eigen::Vector3d& translation) {
  ScenePose pose = FemurPose(rotation, translation);
  pose.bodies["pelvis"] = pose.bodies["femur"];
  return pose;
}

}  // namespace musclewarp
