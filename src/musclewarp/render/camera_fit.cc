// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/camera_fit.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>

namespace musclewarp {

CameraFit FitCamera(const std::vector<PicturePanel>& panels,
                    const View& view,
                    double aspect) {
  constexpr double kMargin = 1.05;
  Eigen::Matrix3d view_from_mesh;
  view_from_mesh.row(0) = view.up.cross(view.toward_viewer);
  view_from_mesh.row(1) = view.up;
  view_from_mesh.row(2) = view.toward_viewer;
  Eigen::AlignedBox3d fit, all;
  for (const PicturePanel& panel : panels) {
    for (const PictureMesh& mesh : panel.meshes) {
      const Points in_view = mesh.surface.points * view_from_mesh.transpose();
      const Eigen::AlignedBox3d box(
          in_view.colwise().minCoeff().transpose().eval(),
          in_view.colwise().maxCoeff().transpose().eval());
      all.extend(box);
      if (mesh.fit) fit.extend(box);
    }
  }
  CHECK(!fit.isEmpty()) << "nothing to draw";
  const double half_height =
      kMargin * std::max(fit.sizes().y(), fit.sizes().x() / aspect) / 2;
  const double depth = std::max(all.max().z() - fit.center().z(),
                                fit.center().z() - all.min().z());
  // Keeps the picture from being empty for a point or a sheet seen edge-on.
  const double least = 1e-6 * (1 + fit.center().norm());
  return {view_from_mesh.transpose() * fit.center(),
          std::max(half_height, least),
          depth + std::max(depth, 1.0) * 1e-3};
}

}  // namespace musclewarp
