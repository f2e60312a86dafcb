// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "musclewarp/phantom/field.h"

namespace musclewarp::phantom {

// A cross section of a strap. A round muscle has no half width, a flat one has
// a half width of several times its half thickness. All lengths are in mm.
struct StrapNode {
  Eigen::Vector3d centre;
  // The direction in which the cross section is wide: unit length, roughly
  // orthogonal to the curve through the centres.
  Eigen::Vector3d across;
  // From the centre to the middle of the rounded edge.
  double half_width = 0;
  // At the centre; at the edges the strap is 0.6 times as thick.
  double half_thickness = 0;
};

// A muscle as a strap along the Catmull-Rom curve through the nodes: the points
// within the half thickness of a ruled surface, which `across` and `half_width`
// span along the curve. The ends are round. It is the flat relative of a sweep.
// Precondition (CHECKed): there are at least two nodes.
Field Strap(const std::vector<StrapNode>& nodes);

// Returns a box that contains the strap with at least `margin` mm around it.
Eigen::AlignedBox3d StrapBox(const std::vector<StrapNode>& nodes,
                             double margin);

}  // namespace musclewarp::phantom
