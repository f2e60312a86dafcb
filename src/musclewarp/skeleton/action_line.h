// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A line of action: the polyline a muscle follows, in the rest pose.
struct ActionLine {
  std::string name;
  Points rest;  // #P x 3, mm, at least two points, neighbours distinct
  // The body each point is fixed to, #P names, or empty if not known.
  std::vector<std::string> bodies;
};

// Where a pose puts the line.
struct LineTarget {
  Points points;  // #P x 3, mm
  // Rotation of the body each point is fixed to, target_from_rest; empty where
  // the body is not known. #P entries.
  std::vector<std::optional<Eigen::Matrix3d>> body_rotations;
};

}  // namespace musclewarp
