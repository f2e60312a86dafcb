// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/coordinate_limits.h"

#include <sstream>

#include "musclewarp/base/input_error.h"

namespace musclewarp {
namespace {

// False for NaN, too.
bool IsAllowed(const Eigen::RowVector3d& place) {
  return (place.array().abs() <= kLargestCoordinate).all();
}

std::string PlaceText(const Eigen::RowVector3d& place) {
  std::ostringstream text;
  text << "is at (" << place[0] << ", " << place[1] << ", " << place[2]
       << ") mm";
  return text.str();
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
                     PlaceText(place),
                     AllowedCoordinates());
  }
}

void CheckCoordinates(const std::string& where,
                      const Eigen::Matrix4d& transform) {
  const Eigen::RowVector3d translation =
      transform.topRightCorner<3, 1>().transpose();
  if (IsAllowed(translation) && transform.allFinite()) return;
  throw InputError(
      where, "its frame " + PlaceText(translation), AllowedCoordinates());
}

}  // namespace musclewarp
