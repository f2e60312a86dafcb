// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "exchange/small_model.h"

#include <algorithm>

#include "exchange/star_mesh.h"
#include "support/meshes.h"

namespace musclewarp {

ElementModel SmallModel::Model() const {
  return ElementModelOf(
      "a test", names, pose, attachments, gaps, /*contact_reach=*/4, mesh);
}

SmallModel MakeSmallModel() {
  SmallModel small;
  small.names = {{"psoas", "iliacus"}, {"femur"}};
  small.pose.muscles = {Icosphere(10, 1),
                        MovedBy(Icosphere(10, 2), {1.0 / 3 + 22, 0, 0})};
  small.pose.bones = {MovedBy(Icosphere(10, 1), {46, 0, 0})};
  small.pose.bone_files = {"femur.ply"};
  small.pose.lines = {
      {"psoas", {}, {Points{{0, -6, -8}, {0, 0, 0}, {0, 6, 8}}}},
      {"iliacus", {}, {}}};
  // Any triangle, so that its corners are neighbours.
  const Eigen::RowVector3i corners = small.pose.muscles[0].triangles.row(0);
  std::vector<int> attached(corners.data(), corners.data() + 3);
  std::sort(attached.begin(), attached.end());
  small.attachments.muscles["psoas"] = {{"pelvis", attached}};
  small.attachments.bones["femur"] = "thigh";
  MeshGap gap;
  gap.a = "psoas";
  gap.b = "iliacus";
  gap.at_least_mm = 1.25;
  small.gaps = {gap};
  // The elements of the second muscle come first, as a mesher may have them.
  const TriangleSoup surface = JoinedSurface(small.pose.muscles);
  const auto first = static_cast<int>(small.pose.muscles[0].points.rows());
  small.mesh.points = surface.points;
  AddStar(small.pose.muscles[1].triangles,
          first,
          small.pose.muscles[1].points.colwise().mean(),
          &small.mesh);
  AddStar(small.pose.muscles[0].triangles,
          0,
          Eigen::RowVector3d::Zero(),
          &small.mesh);
  return small;
}

}  // namespace musclewarp
