// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/tendon_course.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>

#include "musclewarp/fibres/distance_outside.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

using Eigen::Index;
using Eigen::RowVector3d;

// The distance of neighbouring points while the course is looked for, mm.
constexpr double kSpacing = 6;
// That of the course, mm.
constexpr double kSpacingOfCourse = 10;
// Sweeps over the points. The start is straight between corners, so that only
// what bones push aside has to be shortened: of that, a twentieth is left where
// corners are twenty points apart.
constexpr int kSweeps = 120;
// Bones farther from the corners than this do not matter, mm.
constexpr double kFarBone = 30;

struct Course {
  Points points;
  std::vector<bool> is_corner;
};

Course StraightCourse(const Points& corners) {
  std::vector<RowVector3d> points = {corners.row(0)};
  std::vector<bool> is_corner = {true};
  for (Index c = 1; c < corners.rows(); ++c) {
    const RowVector3d way = corners.row(c) - corners.row(c - 1);
    CHECK_GT(way.norm(), 0);
    const int pieces = std::max(1, static_cast<int>(way.norm() / kSpacing));
    for (int i = 1; i <= pieces; ++i) {
      points.emplace_back(corners.row(c - 1) + way * i / pieces);
      is_corner.push_back(i == pieces);
    }
  }
  Course course;
  course.points.resize(static_cast<Index>(points.size()), 3);
  for (size_t i = 0; i < points.size(); ++i) course.points.row(i) = points[i];
  course.is_corner = std::move(is_corner);
  return course;
}

std::vector<const TriangleBvh*> BonesNear(
    const Points& corners, const std::vector<const TriangleBvh*>& bones) {
  const RowVector3d low = corners.colwise().minCoeff().array() - kFarBone;
  const RowVector3d high = corners.colwise().maxCoeff().array() + kFarBone;
  std::vector<const TriangleBvh*> near;
  for (const TriangleBvh* bone : bones) {
    if (bone->num_triangles() == 0) continue;
    const RowVector3d middle = (low + high) / 2;
    const double reach = (high - low).norm() / 2;
    if (bone->box().SquaredDistance(middle) <= reach * reach) {
      near.push_back(bone);
    }
  }
  return near;
}

}  // namespace

Points TendonCourse(const Points& corners,
                    const std::vector<const TriangleBvh*>& bones) {
  CHECK_GE(corners.rows(), 2);
  const std::vector<const TriangleBvh*> near = BonesNear(corners, bones);
  Course course = StraightCourse(corners);
  Points& points = course.points;
  const Index last = points.rows() - 1;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (Index i = 1; i < last; ++i) {
      if (course.is_corner[i]) continue;
      points.row(i) = (points.row(i - 1) + points.row(i + 1)) / 2;
      const double from_end =
          kSpacing * static_cast<double>(std::min(i, last - i));
      const double clearance = std::min(kTendonClearance, from_end / 2);
      const PlaceBeside place = PlaceBesideMeshes(near, points.row(i));
      if (place.distance >= clearance) continue;
      points.row(i) += (clearance - place.distance) * place.outward;
    }
  }
  const int pieces = std::max(
      1,
      static_cast<int>(std::lround(PolylineLength(points) / kSpacingOfCourse)));
  return Resampled(points, pieces + 1);
}

}  // namespace musclewarp
