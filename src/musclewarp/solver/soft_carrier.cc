// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/soft_carrier.h"

#include <glog/logging.h>

#include <algorithm>

#include "musclewarp/geometry/mean_value_coordinates.h"
#include "musclewarp/scene/line_targets.h"
#include "musclewarp/skeleton/sampling.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

SoftCarrier CarrierOf(const Points& area, const MuscleModel& part) {
  CHECK_GT(area.rows(), 0);
  CHECK(part.HasLines());
  constexpr double kLeastRadius = 2;  // mm
  const Eigen::RowVector3d middle = area.colwise().mean();
  const double radius = (area.rowwise() - middle).rowwise().norm().mean();
  return {
      part.name,
      part.lines,
      part.guides,
      SmoothRotations(
          Points(middle), part.guides.lines, std::max(radius, kLeastRadius)),
      MeanValueCoordinates(area, part.coarse_rest, part.coarse_triangles)
          .colwise()
          .mean()};
}

Eigen::Matrix4d TransformOf(const SoftCarrier& carrier, const ScenePose& pose) {
  const std::vector<ActionLine>& guides = carrier.guides.lines;
  const std::vector<LineTarget> targets =
      GuideTargets(carrier.guides, LineTargets(carrier.lines, pose));
  Eigen::RowVector3d before = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d after = Eigen::RowVector3d::Zero();
  for (size_t p = 0; p < carrier.field.places.size(); ++p) {
    const SegmentPoint& place = carrier.field.places[p];
    const double weight = carrier.field.weights(0, p);
    before += weight * PointOnSegment(guides[place.line].rest, place);
    after += weight * PointOnSegment(targets[place.line].points, place);
  }
  const Eigen::Matrix3d rotation =
      RotationsOf(carrier.field, guides, targets, /*use_body_twist=*/true)[0];
  const auto push = pose.pushes.find(carrier.muscle);
  if (push != pose.pushes.end()) after += carrier.from_coarse * push->second;
  Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
  transform.topLeftCorner<3, 3>() = rotation;
  transform.topRightCorner<3, 1>() =
      after.transpose() - rotation * before.transpose();
  return transform;
}

}  // namespace musclewarp
