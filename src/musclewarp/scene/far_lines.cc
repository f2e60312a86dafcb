// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/far_lines.h"

#include <glog/logging.h>

#include <cmath>
#include <sstream>

#include "musclewarp/base/text.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

constexpr double kFar = 5;  // diagonals of the mesh

double DistanceToVertices(const Eigen::RowVector3d& place,
                          const Points& points) {
  return std::sqrt(
      (points.rowwise() - place).rowwise().squaredNorm().minCoeff());
}

}  // namespace

std::vector<std::string> FarLineWarnings(const SceneMuscle& muscle,
                                         const Points& points,
                                         double body_size) {
  CHECK_GT(points.rows(), 0);
  const double diagonal = BoundingBoxDiagonal(points);
  std::vector<std::string> warnings;
  for (const ActionLine& line : muscle.lines) {
    double farthest = 0;
    Eigen::Index index = 0;
    for (Eigen::Index i = 0; i < line.rest.rows(); ++i) {
      const double distance = DistanceToVertices(line.rest.row(i), points);
      if (distance <= farthest) continue;
      farthest = distance;
      index = i;
    }
    if (farthest <= kFar * diagonal) continue;
    std::ostringstream text;
    text << "point " << index << " of line " << line.name << " is "
         << LengthText(farthest, body_size) << " away from muscle "
         << muscle.name << ", which is " << LengthText(diagonal, body_size)
         << " across: are both in millimetres and in one frame?";
    warnings.push_back(text.str());
  }
  return warnings;
}

}  // namespace musclewarp
