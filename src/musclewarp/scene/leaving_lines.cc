// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/leaving_lines.h"

#include "musclewarp/base/infinity.h"
#include "musclewarp/mesh/transformed.h"
#include "musclewarp/scene/line_targets.h"

namespace musclewarp {
namespace {

// A drift of an attachment above this is anatomically implausible, mm.
constexpr double kLargestDrift = 2;

struct LineEnd {
  const ActionLine* line = nullptr;
  Eigen::Index point = 0;  // index of the first or last point of the line
};

// Returns the line end nearest to the centre of the attachment.
LineEnd NearestEnd(const std::vector<ActionLine>& lines,
                   const Attachment& attachment) {
  const Eigen::RowVector3d middle = attachment.points.colwise().mean();
  LineEnd nearest;
  double least = kInfinity;
  for (const ActionLine& line : lines) {
    for (const Eigen::Index point : {Eigen::Index{0}, line.rest.rows() - 1}) {
      const double distance = (line.rest.row(point) - middle).norm();
      if (distance >= least) continue;
      least = distance;
      nearest = {&line, point};
    }
  }
  return nearest;
}

}  // namespace

std::optional<LeavingLine> FindLeavingLine(
    const std::vector<ActionLine>& lines,
    const Attachment& attachment,
    const std::vector<ScenePose>& poses) {
  const LineEnd end = NearestEnd(lines, attachment);
  if (!end.line) return std::nullopt;
  LeavingLine leaving;
  for (const ScenePose& pose : poses) {
    const Points target =
        LineTargets(lines, pose)[end.line - lines.data()].points;
    const Points attached = Transformed(end.line->rest.row(end.point),
                                        BodyTransform(pose, attachment.body));
    const double distance = (target.row(end.point) - attached).norm();
    if (distance > leaving.distance) {
      leaving = {end.line->name, pose.name, distance};
    }
  }
  if (leaving.distance <= kLargestDrift) return std::nullopt;
  return leaving;
}

}  // namespace musclewarp
