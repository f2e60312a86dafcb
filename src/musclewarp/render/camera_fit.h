// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/render/picture.h"

namespace musclewarp {

// Where a camera in parallel projection is, and how much it sees; mm in the
// frame of the meshes.
struct CameraFit {
  // The point in the middle of the picture.
  Eigen::Vector3d center;
  // Half the height of the picture.
  double half_height;
  // Everything, the meshes that do not fit the picture included, is nearer to
  // the centre than this along the line of sight.
  double depth;
};

// Places the camera so that all meshes with `fit` of all panels are in a
// picture of the given width / height, with a margin of 5 %; panels beside each
// other thus have the same scale. Precondition (CHECKed): there is a mesh with
// `fit`.
CameraFit FitCamera(const std::vector<PicturePanel>& panels,
                    const View& view,
                    double aspect);

}  // namespace musclewarp
