// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <musclewarp/musclewarp.h>

#include <cmath>
#include <iostream>

namespace mw = musclewarp;

// A spindle along z, 100 mm long: 11 rings of 12 points and two tips.
mw::SceneMuscle Spindle(const std::string& name, double x) {
  mw::SceneMuscle muscle = {name, mw::Points(134, 3), mw::Triangles(264, 3)};
  for (int v = 0, f = 0; v < 132; ++v) {
    const double z = v / 12 + 1, angle = M_PI / 6 * (v % 12);
    const double radius = 10 * std::sin(M_PI / 12 * z);
    muscle.points.row(v) << x + radius * std::cos(angle),
        radius * std::sin(angle), 100 * z / 12;
    const int next = v % 12 < 11 ? v + 1 : v - 11;
    muscle.triangles.row(f++) << v, next, v < 120 ? v + 12 : 133;
    muscle.triangles.row(f++) << next, v, v >= 12 ? next - 12 : 132;
  }
  muscle.points.bottomRows<2>() << x, 0, 0, x, 0, 100;
  muscle.lines.push_back({name, mw::Points{{x, 0, 2}, {x, 0, 98}}, {}});
  return muscle;
}

int main() {
  mw::Scene scene;
  scene.muscles = {Spindle("psoas", 0), Spindle("iliacus", 19)};
  const mw::SceneMuscle shaft = Spindle("femur", 45);
  scene.bones.push_back({"femur", shaft.points, shaft.triangles});
  mw::Deformer deformer(scene, mw::DeformerOptions());

  mw::ScenePose pose;
  pose.bodies["femur"] = Eigen::Matrix4d::Identity();
  pose.bodies["femur"](0, 3) = -10;  // mm: 4 mm into the iliacus
  const mw::Frame frame = deformer.MoveTo(pose);
  std::cout << frame.FullReport();
  return frame.IsUsable() && frame.intersections.IsClean() ? 0 : 1;
}
