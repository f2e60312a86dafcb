// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/coordinate_limits.h"

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/text.h"

namespace musclewarp {
namespace {

// Returns false for NaN.
bool IsAllowed(const Eigen::RowVector3d& place) {
  return (place.array().abs() <= kLargestCoordinate).all();
}

// Returns a text such as "is at (2e+07, 0, 0) mm".
std::string WhereItIs(const Eigen::RowVector3d& place) {
  return "is at (" + NumberText(place[0]) + ", " + NumberText(place[1]) + ", " +
         NumberText(place[2]) + ") mm";
}

}  // namespace

std::string AllowedCoordinates() { return "allowed: -1e7 to 1e7 mm"; }

void CheckCoordinates(const std::string& where,
                      const Points& points,
                      double body_size) {
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Eigen::RowVector3d place = body_size * points.row(i);
    if (IsAllowed(place)) continue;
    throw InputError(where + ": point " + std::to_string(i),
                     WhereItIs(place),
                     AllowedCoordinates());
  }
}

void CheckCoordinates(const std::string& where,
                      const Eigen::Matrix4d& transform) {
  const Eigen::RowVector3d translation =
      transform.topRightCorner<3, 1>().transpose();
  if (IsAllowed(translation) && transform.allFinite()) return;
  throw InputError(
      where, "its frame " + WhereItIs(translation), AllowedCoordinates());
}

}  // namespace musclewarp
