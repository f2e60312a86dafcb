// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The terms of the energy of taut lines (taut_lines.h) in a pose.

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/skeleton/action_line.h"
#include "musclewarp/skeleton/taut_lines.h"

namespace musclewarp {

// The terms of one line, moved with its bodies.
struct PosedLine {
  const LineSupports* supports;
  Eigen::VectorXd lengths;         // of the segments at rest, #P - 1
  Eigen::VectorXd offsets;         // z, #P
  Points carried, bends, outward;  // p', u', n', #P x 3
};

// The terms between two lines of a group.
struct PosedTie {
  int a, b;
  const Eigen::VectorXd* stiffness;
  Points difference;  // r', #P x 3
};

// Lines that are solved together, as they are tied to each other.
struct PosedGroup {
  std::vector<int> members;  // indices of the lines
  std::vector<PosedLine> lines;
  std::vector<PosedTie> ties;
  Eigen::Index num_points;

  int size() const { return static_cast<int>(lines.size()); }

  // The row of the first of the three unknowns of an inner point.
  Eigen::Index Row(Eigen::Index point, int line) const {
    return 3 * ((point - 1) * size() + line);
  }
  Eigen::Index num_unknowns() const { return 3 * (num_points - 2) * size(); }
};

// Returns the groups of the taut lines among `lines`. Preconditions (CHECKed):
// as for TautPoints.
std::vector<PosedGroup> PosedGroups(const std::vector<ActionLine>& lines,
                                    const std::vector<PointMotions>& motions);

// Turns a direction with a body (or gives its rate, for the rate of the body).
Eigen::RowVector3d TurnedBy(const Eigen::Matrix4d& motion,
                            const Eigen::RowVector3d& direction);

}  // namespace musclewarp
