// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/phantom/field.h"
#include "musclewarp/phantom/strap.h"

namespace musclewarp::phantom {

// The way of a made-up muscle from one bone to another: over bones and over
// other muscles, as a string would run that is pulled over them.

// A solid that a muscle enters by at most `depth` mm.
struct PathObstacle {
  Field field;
  // Contains the solid; used to leave out what is far away.
  Eigen::AlignedBox3d box;
  double depth = 0;
};

// Returns the outward normal of a solid at p: the gradient of its field, at
// unit length.
Eigen::Vector3d NormalOf(const Field& field, const Eigen::Vector3d& p);

// Returns how far, in mm, a cross section of a strap is deeper in the obstacle
// than its depth allows, at its middle and near both edges; 0 or below if it is
// not too deep anywhere.
double Excess(const StrapNode& node, const PathObstacle& obstacle);

// Returns the nodes with their centres moved such that the strap is taut and
// keeps out of the obstacles, apart from the first and the last node, which
// stay. Flat straps turn their flat side to `ground`, the solid they lie on.
// What is returned need not keep out of all obstacles, since there may be no
// room: see Excess.
std::vector<StrapNode> TautPath(std::vector<StrapNode> nodes,
                                const std::vector<PathObstacle>& obstacles,
                                const Field& ground);

// Returns the polyline through the centres, #N x 3, mm.
Points CentresOf(const std::vector<StrapNode>& nodes);

}  // namespace musclewarp::phantom
