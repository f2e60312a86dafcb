// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Multiply all lengths by a factor above 0, areas by its square and volumes by
// its cube: in meshes, in files that will be read later, in lines, attachments
// and poses, including poses that a model will provide. Scene::body_size does
// not change. Scaling by a power of two is exact.
void ScaleLengths(double factor, Scene* scene);
void ScaleLengths(double factor, ScenePose* pose);
void ScaleLengths(double factor, ActionLine* line);
void ScaleLengths(double factor, Attachment* attachment);

// Multiplies the translation of a rigid motion (4 x 4).
void ScaleTranslation(double factor, Eigen::Matrix4d* motion);

}  // namespace musclewarp
