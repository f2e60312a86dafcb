// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The surface of a muscle as a skin: each vertex is the mean of where the bones
// of the skin would carry it, with weights of its own (linear blend skinning).
struct SkinWeights {
  Points places;            // #V x 3, mm: of the vertices at rest
  Eigen::MatrixXd weights;  // #V x #bones, from 0 to 1, with the sum 1

  // How far its vertices are from those of the muscle in the frames, mm: on the
  // mean and at most.
  double mean_distance = 0, largest_distance = 0;
};

// Fits weights and places to the vertices of a muscle in some frames. `rest`:
// its vertices at rest, #V x 3, mm. `frames`: the same in each frame.
// `motions`: for each frame the rigid motion of each bone of the skin from
// rest, 4 x 4, mm. Preconditions (CHECKed): there are frames, 1 to
// kMostSkinBones bones, and as many vertices in each frame.
SkinWeights FitSkin(const Points& rest,
                    const std::vector<Points>& frames,
                    const std::vector<std::vector<Eigen::Matrix4d>>& motions);

// All subsets of the bones are tried for each vertex.
constexpr int kMostSkinBones = 6;

}  // namespace musclewarp
