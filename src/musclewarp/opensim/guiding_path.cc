// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/guiding_path.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace musclewarp {
namespace {

// A cubic that rises from 0 at 0 to 1 at 1 with horizontal ends.
double SmoothStep(double t) {
  const double inside = std::clamp(t, 0.0, 1.0);
  return inside * inside * (3 - 2 * inside);
}

// Moves the conditional points between rows `first` and `last`, which are
// always there, towards the straight way between these two. A point gets there
// at the same part of the length as on its detour.
void FadeBetween(int first,
                 int last,
                 const std::vector<double>& shares,
                 Points* path) {
  const Points detour = path->middleRows(first, last - first + 1);
  std::vector<double> lengths = {0};
  for (int i = 1; i < detour.rows(); ++i) {
    lengths.push_back(lengths.back() +
                      (detour.row(i) - detour.row(i - 1)).norm());
  }
  if (lengths.back() == 0) return;
  const Eigen::RowVector3d start = detour.row(0);
  const Eigen::RowVector3d way = detour.row(detour.rows() - 1) - start;
  for (int i = first + 1; i < last; ++i) {
    const Eigen::RowVector3d straight =
        start + lengths[i - first] / lengths.back() * way;
    path->row(i) = straight + shares[i] * (path->row(i) - straight);
  }
}

}  // namespace

double GuidingShare(const Model& model,
                    const PathPoint& point,
                    const CoordinateValues& values) {
  if (point.condition < 0) return 1;
  const bool is_angle =
      model.coordinates[point.condition].kind == CoordinateKind::kRotational;
  const double fade =
      std::min(is_angle ? kGuidingFadeAngle : kGuidingFadeLength,
               (point.range[1] - point.range[0]) / 2);
  if (!(fade > 0)) return IsActive(point, values) ? 1 : 0;
  const double value = values[point.condition];
  return SmoothStep(0.5 + (value - point.range[0]) / fade) *
         SmoothStep(0.5 + (point.range[1] - value) / fade);
}

Points GuidingPath(const Model& model,
                   const ModelMuscle& muscle,
                   const std::vector<Eigen::Matrix4d>& ground_from_body,
                   const CoordinateValues& values) {
  const int count = static_cast<int>(muscle.path.size());
  Points path(count, 3);
  std::vector<double> shares;
  for (int i = 0; i < count; ++i) {
    const PathPoint& point = muscle.path[i];
    path.row(i) = (ground_from_body[point.body] *
                   LocationOnBody(point, values).homogeneous())
                      .head<3>()
                      .transpose();
    shares.push_back(GuidingShare(model, point, values));
  }
  // Conditional points before the first or after the last that is always there
  // have no way to pass on, and stay where they are.
  int last_always = -1;
  for (int i = 0; i < count; ++i) {
    if (muscle.path[i].condition >= 0) continue;
    if (last_always >= 0) FadeBetween(last_always, i, shares, &path);
    last_always = i;
  }
  return path;
}

}  // namespace musclewarp
