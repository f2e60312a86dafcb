// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/render/picture.h"

namespace musclewarp {

// What a camera in parallel projection has to see; millimetres.
struct CameraFit {
  Eigen::Vector3d center;
  double half_height;  // of the picture
  double depth;        // everything lies nearer to the centre, along the view
};

// The camera that holds every mesh with `fit` of every panel, with a margin, in
// a picture of the given width / height. Precondition: there is such a mesh.
CameraFit FitCamera(const std::vector<PicturePanel>& panels,
                    const View& view,
                    double aspect);

}  // namespace musclewarp
