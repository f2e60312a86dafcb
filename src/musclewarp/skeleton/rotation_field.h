// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/skeleton/action_line.h"
#include "musclewarp/skeleton/nearest_segment.h"

namespace musclewarp {

// How the pre-rotations of points around lines follow from the rotations of the
// lines (segment_rotation.h): each is a weighted mean of rotations at places on
// the lines. A place may count for many points.
struct RotationField {
  std::vector<SegmentPoint> places;  // #P

  // #V x #P, rows add up to 1. Empty: point i takes the rotation of place i, so
  // that there are as many places as points.
  Eigen::MatrixXd weights;
};

// Returns the field of the paper (section 2.2): each point takes the rotation
// of the place nearest to it. Neighbours on either side of a joint of the
// polyline, or between two lines, turn differently. `points` is #V x 3, mm.
// Precondition (CHECKed): there are lines.
RotationField NearestRotations(const Points& points,
                               const std::vector<ActionLine>& lines);

// Returns a smooth field: the rotation at x is the mean of the rotations along
// all lines, weighted by ds / (d^2 + r^2)^2 with the distance d of x from the
// place and the radius r, mm, over which joints of a polyline are rounded off.
// The lines are cut into pieces of at most half of r. Precondition (CHECKed):
// there are lines, and r is above 0.
RotationField SmoothRotations(const Points& points,
                              const std::vector<ActionLine>& lines,
                              double radius);

// Returns the rotation of each point (#V) for the targets of the lines. A mean
// of rotations is the normalised sum of their quaternions, each with the sign
// nearer to that with the largest weight. Equal rotations have themselves as
// their mean, to rounding.
std::vector<Eigen::Matrix3d> RotationsOf(const RotationField& field,
                                         const std::vector<ActionLine>& lines,
                                         const std::vector<LineTarget>& targets,
                                         bool use_body_twist);

// Returns by which factor the lines have got longer around each point (#V): the
// means, weighted as those of rotations, of the length of a segment by that at
// rest.
Eigen::VectorXd StretchesOf(const RotationField& field,
                            const std::vector<ActionLine>& lines,
                            const std::vector<LineTarget>& targets);

}  // namespace musclewarp
