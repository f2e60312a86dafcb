// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "support/small_scene.h"

#include <Eigen/Geometry>
#include <string>

#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr double kRadius = 12, kHalfLength = 60;

SceneMuscle MuscleAt(const std::string& name, double x) {
  const TriangleSoup soup =
      MovedBy(Spindle(kRadius, kHalfLength, 3), {x, 0, 0});
  ActionLine line;
  line.name = name + "_line";
  line.rest.resize(3, 3);
  line.rest << x, 0, -55, x, 0, 0, x, 0, 55;
  line.bodies = {"pelvis", "femur", "femur"};
  return {name, soup.points, soup.triangles, {line}, {}, ""};
}

}  // namespace

Scene SmallScene() {
  const TriangleSoup pelvis = MovedBy(Icosphere(20, 3), {0, 0, -85});
  const TriangleSoup femur = MovedBy(Icosphere(20, 3), {0, 0, 85});
  Scene scene;
  scene.name = "small";
  scene.muscles = {MuscleAt("left", -12.5), MuscleAt("right", 12.5)};
  scene.bones.push_back({"pelvis", pelvis.points, pelvis.triangles});
  scene.bones.push_back({"femur", femur.points, femur.triangles});
  return scene;
}

ScenePose FlexedPose(double angle) {
  ScenePose pose;
  pose.name = "flexed";
  pose.time = angle;
  Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
  turn.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
  pose.bodies["femur"] = turn;
  return pose;
}

}  // namespace musclewarp
