// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/plane_section.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace musclewarp {
namespace {

using Edge = std::pair<int, int>;
using Polygon = std::vector<Eigen::RowVector2d>;

// Where the section enters a triangle, and by which edge it leaves it.
struct Crossing {
  Eigen::RowVector2d place;
  Edge next;
};

double Cross(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b) {
  return a[0] * b[1] - a[1] * b[0];
}

// Positive if the corners run counterclockwise.
double SignedArea(const Polygon& polygon) {
  double twice = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    twice += Cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return twice / 2;
}

bool Contains(const Polygon& polygon, const Eigen::RowVector2d& place) {
  bool is_inside = false;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::RowVector2d a = polygon[i] - place;
    const Eigen::RowVector2d b = polygon[(i + 1) % polygon.size()] - place;
    if ((a[1] > 0) == (b[1] > 0)) continue;
    if ((Cross(a, b) > 0) == (b[1] > a[1])) is_inside = !is_inside;
  }
  return is_inside;
}

double DistanceFromBorder(const Polygon& polygon,
                          const Eigen::RowVector2d& place) {
  double nearest = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::RowVector2d a = polygon[i];
    const Eigen::RowVector2d way = polygon[(i + 1) % polygon.size()] - a;
    const double square = way.squaredNorm();
    const double t =
        square > 0 ? std::clamp((place - a).dot(way) / square, 0.0, 1.0) : 0;
    nearest = std::min(nearest, (a + t * way - place).norm());
  }
  return nearest;
}

// Returns the closed curves in which a plane cuts a surface, in coordinates of
// the plane with the place as origin: outer ones run counterclockwise, those
// around cavities clockwise. A vertex on the plane counts as above it, so that
// every triangle is cut in one segment or not at all.
std::vector<Polygon> SectionCurves(const Points& points,
                                   const Triangles& triangles,
                                   const Eigen::RowVector3d& place,
                                   const Eigen::RowVector3d& normal) {
  const Eigen::RowVector3d up = normal.normalized();
  const Eigen::RowVector3d right = up.unitOrthogonal();
  const Eigen::RowVector3d front = up.cross(right);
  const Eigen::VectorXd heights = (points.rowwise() - place) * up.transpose();
  const auto crossing = [&](int a, int b) -> Eigen::RowVector2d {
    // The same from both sides of an edge, to the last bit.
    if (a > b) std::swap(a, b);
    const double t = heights[a] / (heights[a] - heights[b]);
    const Eigen::RowVector3d at =
        points.row(a) + t * (points.row(b) - points.row(a)) - place;
    return {at.dot(right), at.dot(front)};
  };
  std::map<Edge, Crossing> crossings;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int a = triangles(f, k), b = triangles(f, (k + 1) % 3),
                c = triangles(f, (k + 2) % 3);
      const bool is_above = heights[a] >= 0;
      if ((heights[b] >= 0) == is_above || (heights[c] >= 0) == is_above) {
        continue;
      }
      const Edge ab = std::minmax(a, b), ca = std::minmax(c, a);
      if (is_above) {
        crossings[ab] = {crossing(a, b), ca};
      } else {
        crossings[ca] = {crossing(c, a), ab};
      }
    }
  }
  std::vector<Polygon> curves;
  while (!crossings.empty()) {
    Polygon& curve = curves.emplace_back();
    auto at = crossings.begin();
    while (at != crossings.end()) {
      curve.push_back(at->second.place);
      const Edge next = at->second.next;
      crossings.erase(at);
      at = crossings.find(next);
    }
  }
  return curves;
}

}  // namespace

double SectionArea(const Points& points,
                   const Triangles& triangles,
                   const Eigen::RowVector3d& place,
                   const Eigen::RowVector3d& normal) {
  const std::vector<Polygon> curves =
      SectionCurves(points, triangles, place, normal);
  const Eigen::RowVector2d origin(0, 0);
  const Polygon* piece = nullptr;
  double nearest = std::numeric_limits<double>::infinity(), area = 0;
  for (const Polygon& curve : curves) {
    const double signed_area = SignedArea(curve);
    if (signed_area <= 0) continue;
    const double distance =
        Contains(curve, origin) ? 0 : DistanceFromBorder(curve, origin);
    // Of pieces around each other it is in the innermost one.
    if (distance > nearest || (distance == nearest && signed_area >= area)) {
      continue;
    }
    piece = &curve;
    nearest = distance;
    area = signed_area;
  }
  if (!piece) return 0;
  for (const Polygon& curve : curves) {
    const double signed_area = SignedArea(curve);
    if (signed_area < 0 && Contains(*piece, curve[0])) area += signed_area;
  }
  return area;
}

double LargestSectionArea(const Points& points,
                          const Triangles& triangles,
                          const SectionPlanes& planes) {
  double largest = 0;
  for (Eigen::Index i = 0; i < planes.places.rows(); ++i) {
    largest = std::max(
        largest,
        SectionArea(
            points, triangles, planes.places.row(i), planes.normals.row(i)));
  }
  return largest;
}

}  // namespace musclewarp
