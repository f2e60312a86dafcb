// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/nifti_frame.h"

#include <algorithm>
#include <sstream>

namespace musclewarp {

std::string NoteOnOtherQform(const std::string& path,
                             const Eigen::Array3i& size,
                             const Eigen::Matrix4d& sform,
                             const Eigen::Matrix4d& qform) {
  constexpr int kCorners = 8;
  constexpr double kNoticed = 0.1;  // voxels
  double farthest = 0;
  for (int corner = 0; corner < kCorners; ++corner) {
    const Eigen::Vector4d index(corner & 1 ? size[0] - 1 : 0,
                                corner & 2 ? size[1] - 1 : 0,
                                corner & 4 ? size[2] - 1 : 0,
                                1);
    farthest = std::max(farthest, ((sform - qform) * index).norm());
  }
  const double shortest =
      sform.topLeftCorner<3, 3>().colwise().norm().minCoeff();
  if (farthest <= kNoticed * shortest) return "";
  std::ostringstream text;
  text.precision(3);
  text
      << path << " has an sform and a qform that differ by up to "
      << farthest / shortest
      << " voxels: the sform is taken; if the surfaces are in the wrong place, "
         "the qform is right";
  return text.str();
}

}  // namespace musclewarp
