// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mujoco/mjcf_file.h"
#include "musclewarp/mujoco/mjcf_tree.h"
#include "musclewarp/mujoco/skin_slides.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// Adds slides to a skin and its model: for each a small body on `body` (of the
// model, on which they are fitted) with a joint, a coupling that keeps it on
// its polynomial, and a bone of the skin, whose weights are taken off those of
// the body. `coordinates`: those to which SkinSlide::coordinate refers.
// `body_from_rest`: how the meshes at rest lie in the body, mm.
void AddSlides(const SkinSlides& slides,
               const std::vector<Coordinate>& coordinates,
               int body,
               const Eigen::Matrix4d& body_from_rest,
               MjcfTree* tree,
               MjcfSkin* skin);

}  // namespace musclewarp
