// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <musclewarp/musclewarp.h>

#include <iostream>

namespace mw = musclewarp;

// A block from z = `low` to `high`, mm.
mw::TriangleSoup Block(double low, double high) {
  mw::TriangleSoup block;
  block.points.resize(8, 3);
  for (int v = 0; v < 8; ++v) {
    block.points.row(v) << (v & 1 ? 20 : -20), (v & 2 ? 20 : -20),
        (v & 4 ? high : low);
  }
  block.triangles.resize(12, 3);
  block.triangles << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6,  // below, above
      0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3,                 // front, back
      0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5;                 // both sides
  return block;
}

// A knee that is given, between blocks that stand in for bones.
int main() {
  mw::FoundJoint knee;
  knee.kind = mw::JointKind::kKnee;
  knee.side = mw::Side::kRight;
  mw::ArticulationOptions options;
  options.given = {knee};
  const mw::Articulation leg =
      mw::Articulate({mw::BoneOfName("femur_r", Block(2, 400)),
                      mw::BoneOfName("right tibia", Block(-350, -2))},
                     options);
  const auto report = mw::JointsJson(leg, options.axes);
  std::cout << report["joints"][0]["name"] << "\n";
  const std::string model = mw::ArticulatedModelText(leg, "leg");
  return leg.joints.size() == 1 &&
                 mw::CoordinateNames(leg).at(0) == "knee_angle_r" &&
                 model.find("knee_angle_r") != std::string::npos
             ? 0
             : 1;
}
