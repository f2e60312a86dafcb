// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

namespace musclewarp {

// The order in which postures are visited. Each is reached by a short move from
// one that was visited before, or from the rest pose.
struct PostureTree {
  // The postures in the order of their visits.
  std::vector<int> order;

  // For each of them, in that order, the place in `order` of the posture from
  // which it is reached, or -1 for the rest pose.
  std::vector<int> reached_from;
};

// Returns the tree in which each posture is reached from the nearest of those
// that are nearer to rest than itself, of which rest is one. Moves so lead
// outwards, and there are few of them on the way to any posture. The tree is
// visited depth first: what lies beyond a posture follows it without a gap, so
// that consecutive visits are branches, whose states need only be kept along
// the way to rest.
//
// `postures`: #postures x #coordinates, and `rest`: 1 x #coordinates, in units
// in which moves of different coordinates can be compared.
PostureTree TreeFrom(const Eigen::RowVectorXd& rest,
                     const Eigen::MatrixXd& postures);

}  // namespace musclewarp
