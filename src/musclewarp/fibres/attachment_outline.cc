// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/attachment_outline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "musclewarp/scene/attachment_area.h"

namespace musclewarp {
namespace {

using Eigen::RowVector2d;
using Eigen::RowVector3d;

// A closed polygon, projected along its mean normal.
class FlatOutline {
 public:
  explicit FlatOutline(const Points& points)
      : center_(points.colwise().mean()) {
    const Eigen::Index count = points.rows();
    RowVector3d area = RowVector3d::Zero();
    for (Eigen::Index i = 0; i < count; ++i) {
      const RowVector3d a = points.row(i) - center_;
      const RowVector3d b = points.row((i + 1) % count) - center_;
      area += a.cross(b) / 2;
    }
    is_flat_ = area.norm() > 0;
    if (!is_flat_) return;
    const RowVector3d normal = area.normalized();
    normal_ = normal;
    depth_ = std::sqrt(area.norm() / M_PI);
    axes_.col(0) = normal.unitOrthogonal().transpose();
    axes_.col(1) = normal.cross(axes_.col(0).transpose()).transpose();
    corners_ = (points.rowwise() - center_) * axes_;
  }

  // Returns true if the outline encloses a point at least once. Points farther
  // from its plane than the radius of a circle of the same area are not
  // enclosed: they are on another side of the muscle.
  bool GoesRound(const RowVector3d& point) const {
    if (!is_flat_ || std::abs((point - center_).dot(normal_)) > depth_) {
      return false;
    }
    const RowVector2d at = (point - center_) * axes_;
    double turn = 0;
    for (Eigen::Index i = 0; i < corners_.rows(); ++i) {
      const RowVector2d a = corners_.row(i) - at;
      const RowVector2d b = corners_.row((i + 1) % corners_.rows()) - at;
      turn += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return std::abs(turn) > M_PI;
  }

 private:
  RowVector3d center_, normal_;
  double depth_ = 0;  // the radius of a circle of the same area, mm
  bool is_flat_ = false;
  Eigen::Matrix<double, 3, 2> axes_;
  Eigen::Matrix<double, Eigen::Dynamic, 2> corners_;
};

}  // namespace

Attachment FilledOutline(const Attachment& attachment,
                         const TriangleSoup& muscle,
                         const std::vector<BodySurface>& bodies) {
  std::vector<int> vertices = VerticesInArea(attachment, muscle.points);
  const auto body =
      std::find_if(bodies.begin(), bodies.end(), [&](const BodySurface& of) {
        return of.body == attachment.body;
      });
  if (body != bodies.end()) {
    const FlatOutline outline(attachment.points);
    for (Eigen::Index v = 0; v < muscle.points.rows(); ++v) {
      if (outline.GoesRound(muscle.points.row(v)) &&
          body->Distance(muscle.points.row(v)) <= attachment.radius) {
        vertices.push_back(static_cast<int>(v));
      }
    }
  }
  if (vertices.empty()) return attachment;
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  Attachment filled = attachment;
  filled.is_outline = false;
  filled.points = muscle.points(vertices, Eigen::all);
  filled.radius = kPointsAlone;
  return filled;
}

}  // namespace musclewarp
