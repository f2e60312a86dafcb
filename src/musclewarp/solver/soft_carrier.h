// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene_pose.h"
#include "musclewarp/skeleton/action_line.h"
#include "musclewarp/skeleton/guides.h"
#include "musclewarp/skeleton/rotation_field.h"

namespace musclewarp {

// What carries an area in which a muscle is attached to another soft part: the
// lines of that part, which its mesh follows. It does not depend on the shape
// of the mesh, so that muscles are still solved for one by one.
struct SoftCarrier {
  std::vector<ActionLine> lines;
  Guides guides;
  RotationField field;  // of one point, the middle of the area
};

// Returns the carrier of an area (#P x 3, mm, at rest) on a soft part with the
// given lines and guides. Precondition (CHECKed): there are lines and points.
SoftCarrier CarrierOf(const Points& area,
                      const std::vector<ActionLine>& lines,
                      const Guides& guides);

// Returns target_from_rest of the area in a pose: the mean motion of the places
// on the guides, weighted by how near they are. It is the identity at rest, to
// rounding, and the common motion if all bodies move together.
Eigen::Matrix4d TransformOf(const SoftCarrier& carrier, const ScenePose& pose);

}  // namespace musclewarp
