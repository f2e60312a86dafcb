// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/planes_across.h"

#include <glog/logging.h>

#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {

SectionPlanes PlanesAcross(const Points& line, int count) {
  constexpr double kHalfChord = 0.05;      // of the length
  constexpr double kShortestChord = 1e-3;  // of the length
  CHECK_GT(count, 0);
  const double length = PolylineLength(line);
  CHECK_GT(length, 0);
  const Eigen::VectorXd shares =
      (Eigen::VectorXd::LinSpaced(count, 0, count - 1).array() + 0.5) / count;
  const Points places = PointsAtShares(line, shares);
  const Points before =
      PointsAtShares(line, (shares.array() - kHalfChord).max(0).matrix());
  const Points after =
      PointsAtShares(line, (shares.array() + kHalfChord).min(1).matrix());
  SectionPlanes planes;
  planes.places.resize(count, 3);
  planes.normals.resize(count, 3);
  Eigen::Index kept = 0;
  for (int i = 0; i < count; ++i) {
    const Eigen::RowVector3d chord = after.row(i) - before.row(i);
    if (chord.norm() < kShortestChord * length) continue;
    planes.places.row(kept) = places.row(i);
    planes.normals.row(kept++) = chord;
  }
  planes.places.conservativeResize(kept, 3);
  planes.normals.conservativeResize(kept, 3);
  return planes;
}

}  // namespace musclewarp
