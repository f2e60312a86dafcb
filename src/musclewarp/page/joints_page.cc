// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/page/joints_page.h"

#include "musclewarp/joints/joints_file.h"
#include "musclewarp/page/joints_page_bundle.h"
#include "musclewarp/page/page_parts.h"
#include "musclewarp/run/paths_in_json.h"

namespace musclewarp {
namespace {

// Forward, up and right in the frame of the bones, in columns.
Eigen::Matrix3d BodyDirections(const Articulation& articulation,
                               const std::string& axes) {
  if (axes.empty()) {
    for (const FoundJoint& joint : articulation.joints) {
      if (joint.IsFound()) return joint.parent_axes;
    }
  }
  const std::string known = axes.empty() ? "LPS" : axes;
  Eigen::Matrix3d directions;
  int column = 0;
  for (const char* name : {"anterior", "superior", "right"}) {
    directions.col(column++) = ParseView(name, known, "right").toward_viewer;
  }
  return directions;
}

nlohmann::ordered_json ViewsOf(const Eigen::Matrix3d& directions) {
  const Eigen::Vector3d forward = directions.col(0), up = directions.col(1),
                        right = directions.col(2);
  return {{"anterior", ViewJson({forward, up})},
          {"posterior", ViewJson({-forward, up})},
          {"right", ViewJson({right, up})},
          {"left", ViewJson({-right, up})},
          {"superior", ViewJson({up, forward})}};
}

}  // namespace

std::string JointsPageHtml(const Articulation& articulation,
                           const JointsPageOptions& options) {
  std::vector<const Points*> points;
  for (const Bone& bone : articulation.bones) {
    points.push_back(&bone.mesh.points);
  }
  const double step = RoundingStep(points);
  PackedNumbers packed;
  nlohmann::ordered_json bones = nlohmann::ordered_json::array();
  for (const Bone& bone : articulation.bones) {
    bones.push_back(BoneShapeJson(
        bone.name, bone.mesh, step, options.max_bone_triangles, &packed));
    bones.back()["body"] = bone.body;
  }
  nlohmann::ordered_json json = {
      {"name", options.name},
      {"views", ViewsOf(BodyDirections(articulation, options.axes))},
      {"joints_file", JointsJson(articulation, options.axes)},
      {"step_mm", step},
      {"bones", bones}};
  RemoveFolders(&json);
  return PageText({kJointsPageBundle, kJointsPageBundleSize},
                  "joints",
                  json,
                  packed.Base64());
}

}  // namespace musclewarp
