// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene_pose.h"
#include "musclewarp/skeleton/action_line.h"
#include "musclewarp/skeleton/guides.h"
#include "musclewarp/skeleton/rotation_field.h"

namespace musclewarp {

struct MuscleModel;

// What carries an area in which a muscle is attached to another soft part: the
// lines of that part, which its mesh follows, and the push of bones on it. It
// does not depend on contact, so that muscles are still solved for one by one.
struct SoftCarrier {
  std::string muscle;
  std::vector<ActionLine> lines;
  Guides guides;
  RotationField field;  // of one point, the middle of the area

  // The mean of the area from the coarse vertices of the part, 1 x N: it goes
  // along with what pushes the part aside (ScenePose::pushes).
  Eigen::RowVectorXd from_coarse;
};

// Returns the carrier of an area (#P x 3, mm, at rest) on a soft part.
// Precondition (CHECKed): the part has lines, and there are points.
SoftCarrier CarrierOf(const Points& area, const MuscleModel& part);

// Returns target_from_rest of the area in a pose: the mean motion of the places
// on the guides, weighted by how near they are. It is the identity at rest, to
// rounding, and the common motion if all bodies move together.
Eigen::Matrix4d TransformOf(const SoftCarrier& carrier, const ScenePose& pose);

}  // namespace musclewarp
