// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/path_beyond.h"

#include <algorithm>
#include <limits>

#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

// The nearest place on a polyline.
struct PlaceOnPath {
  double distance = std::numeric_limits<double>::infinity();  // mm
  double along = 0;  // the length of the path up to it, mm
};

PlaceOnPath NearestOnPath(const Points& path, const Eigen::RowVector3d& point) {
  PlaceOnPath nearest;
  double along = 0;
  for (Eigen::Index i = 0; i + 1 < path.rows(); ++i) {
    const Eigen::RowVector3d way = path.row(i + 1) - path.row(i);
    const double length = way.norm();
    const double t =
        length > 0
            ? std::clamp(
                  (point - path.row(i)).dot(way) / (length * length), 0.0, 1.0)
            : 0;
    const double distance = (path.row(i) + t * way - point).norm();
    if (distance < nearest.distance) nearest = {distance, along + t * length};
    along += length;
  }
  return nearest;
}

}  // namespace

PartsBeyond FindPartsBeyond(const Points& path, const Points& carried) {
  constexpr double kOnPath = 5;       // mm
  constexpr double kShortest = 1e-3;  // mm
  if (path.rows() < 2 || carried.rows() < 2) return {};
  const PlaceOnPath first = NearestOnPath(path, carried.row(0));
  const PlaceOnPath last = NearestOnPath(path, carried.row(carried.rows() - 1));
  if (std::max(first.distance, last.distance) > kOnPath) return {};
  PartsBeyond beyond;
  beyond.length =
      first.along + std::max(0.0, PolylineLength(path) - last.along);
  if (last.along <= first.along || beyond.length <= kShortest) return {};
  for (Eigen::Index i = 0; i < path.rows(); ++i) {
    const double along = PolylineLength(path.topRows(i + 1));
    if (along < first.along) ++beyond.points_before;
    if (along > last.along) ++beyond.points_after;
  }
  return beyond;
}

Points DefaultPath(const Model& model, int muscle) {
  const ModelMuscle& of = model.muscles[muscle];
  if (!of.unsupported.empty()) return {};
  CoordinateValues values = DefaultValues(model);
  ApplyCouplers(model, &values);
  const auto ground_from_body = BodyFrames(model, values);
  Points path(of.path.size(), 3);
  for (size_t i = 0; i < of.path.size(); ++i) {
    const PathPoint& point = of.path[i];
    if (point.is_moving || point.condition >= 0) return {};
    path.row(i) = (ground_from_body[point.body] * point.location.homogeneous())
                      .head<3>()
                      .transpose();
  }
  return path;
}

Points WithPartsBeyond(const Points& line,
                       const PartsBeyond& beyond,
                       const Model& model,
                       const std::string& muscle,
                       const CoordinateValues& values) {
  if (beyond.points_before + beyond.points_after == 0) return line;
  const std::vector<PathPoint>& path =
      model.muscles[model.FindMuscle(muscle)].path;
  const auto ground_from_body = BodyFrames(model, values);
  Points whole(beyond.points_before + line.rows() + beyond.points_after, 3);
  const auto put = [&](Eigen::Index row, const PathPoint& point) {
    whole.row(row) =
        (ground_from_body[point.body] * point.location.homogeneous())
            .head<3>()
            .transpose();
  };
  for (int i = 0; i < beyond.points_before; ++i) put(i, path[i]);
  whole.middleRows(beyond.points_before, line.rows()) = line;
  for (int i = 1; i <= beyond.points_after; ++i) {
    put(whole.rows() - i, path[path.size() - i]);
  }
  return whole;
}

}  // namespace musclewarp
