// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/base/angles.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// A conditional point is switched on and off at the ends of its range, where
// the path jumps. A muscle that jumped along would not be smooth in time. So
// the path that guides a muscle leaves and reaches the point gradually: over
// this much of its coordinate, half of it on either side of the end, but at
// most over half of the range. If the path is 1 mm shorter without the point,
// that changes a moment arm by 2 mm at most. Twice as much changes the bands of
// moment arms of the fibres of the LHDL hip by 2 per cent of their area.
constexpr double kGuidingFadeAngle = RadiansOf(40);  // rad
constexpr double kGuidingFadeLength = 0.04;          // m

// Returns how much of a path point guides the muscle: 1 for a point that is
// always part of the path, 0 for a conditional one that is switched off, a half
// at an end of its range, and between near there. It is a continuously
// differentiable function of the coordinate.
double GuidingShare(const Model& model,
                    const PathPoint& point,
                    const CoordinateValues& values);

// Returns the polyline along which a muscle is guided, #P x 3, mm: all points
// of its path, conditional ones included, so that their number is the same in
// every pose. A conditional point lies between its location on its body, with a
// share of GuidingShare, and the straight way past it, from the point before to
// the point after that are always there. While no conditional point is near an
// end of its range, this is the path of the model.
//
// `ground_from_body` is the result of BodyFrames or those frames as seen from
// elsewhere; the result is in the same frame.
Points GuidingPath(const Model& model,
                   const ModelMuscle& muscle,
                   const std::vector<Eigen::Matrix4d>& ground_from_body,
                   const CoordinateValues& values);

}  // namespace musclewarp
