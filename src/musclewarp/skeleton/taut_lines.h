// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// Taut lines are elastic bands over one-sided supports: a muscle is under
// tension, so that between its ends it is as short as what supports it allows,
// and lifts off where it bowstrings. The points x of a line minimise
//
//   sum |x_(i+1) - x_i|^2 / (2 l_i)             the band, equally stretched
//   + sum k_i P(u_i' . (x_i - p_i') + z_i)      its supports (stiffness, bends)
//   + sum c_i P(-n_i' . (x_i - p_i'))           its planes (plane_stiffness)
//   + sum h_i / 2 |x_i - p_i'|^2                where it is held (hold)
//   + sum t_i / 2 |x_i - y_i - r_i'|^2          ties to other lines y (ties)
//
// with the ends on their bodies. Here p are the points at rest, l the lengths
// of the segments, and primes mean: moved with the body of the point; r' is the
// mean of what the bodies of both lines make of the difference at rest. P' is 0
// for negative arguments, g^2 / (2 w) up to the onset w (of planes:
// plane_onset), and g - w / 2 beyond it; z_i is such that the supports bear
// exactly the loads at rest.
//
// E is strictly convex, so that the shape is unique and a continuous function
// of the pose, without history. At rest it is the line at rest, and a rigid
// motion of all bodies moves the line with them.

// The motions of the points of a line: for each point a matrix, of its body.
using PointMotions = std::vector<Eigen::Matrix4d>;

// Returns the points of the lines of a muscle, #P x 3 each, mm, where their
// bodies are moved by `motions` (target_from_rest). Lines without supports are
// not taut, and get no points. Preconditions (CHECKed): there is a motion for
// each point of a taut line; tied lines have equally many points.
std::vector<Points> TautPoints(const std::vector<ActionLine>& lines,
                               const std::vector<PointMotions>& motions);

// Returns the energy E (mm) of the taut lines at `points`, #P x 3 each, mm.
double TautEnergy(const std::vector<ActionLine>& lines,
                  const std::vector<PointMotions>& motions,
                  const std::vector<Points>& points);

// Returns the derivatives of TautPoints() with respect to a coordinate on which
// the motions depend, by implicit differentiation at the minimum: #P x 3 each,
// mm/rad (or mm/m). `rates` are the rates of the bodies (RateBetween), one
// matrix for each point: rate * (p, 1) is the velocity of a moved point p.
// `points` are the result of TautPoints for `motions`.
std::vector<Points> TautRates(const std::vector<ActionLine>& lines,
                              const std::vector<PointMotions>& motions,
                              const std::vector<Points>& points,
                              const std::vector<PointMotions>& rates);

}  // namespace musclewarp
