// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/triangle.h"

namespace musclewarp {
namespace {

Eigen::RowVector3d Origin(const Points& points) {
  // Volumes and gradients of closed meshes do not depend on the origin; one
  // near the mesh keeps rounding small.
  return points.rows() > 0 ? Eigen::RowVector3d(points.row(0))
                           : Eigen::RowVector3d(0, 0, 0);
}

// Returns the area of triangle f.
double AreaOf(const Points& points,
              const Triangles& triangles,
              Eigen::Index f) {
  const Eigen::RowVector3d a = points.row(triangles(f, 0));
  const Eigen::RowVector3d b = points.row(triangles(f, 1));
  const Eigen::RowVector3d c = points.row(triangles(f, 2));
  return (b - a).cross(c - a).norm() / 2;
}

}  // namespace

double SignedVolume(const Points& points, const Triangles& triangles) {
  const Eigen::RowVector3d origin = Origin(points);
  double six_volumes = 0;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const Eigen::RowVector3d a = points.row(triangles(f, 0)) - origin;
    const Eigen::RowVector3d b = points.row(triangles(f, 1)) - origin;
    const Eigen::RowVector3d c = points.row(triangles(f, 2)) - origin;
    six_volumes += a.cross(b).dot(c);
  }
  return six_volumes / 6;
}

bool IsConsistentlyOriented(const Triangles& triangles) {
  // How often each edge is passed, and how often from its lower to its higher
  // vertex less the other way.
  struct Passages {
    int all = 0, surplus = 0;
  };
  std::map<std::pair<int, int>, Passages> edges;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const int a = triangles(f, c), b = triangles(f, (c + 1) % 3);
      if (a == b) continue;
      Passages& passages = edges[std::minmax(a, b)];
      ++passages.all;
      passages.surplus += a < b ? 1 : -1;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) {
    return std::abs(edge.second.surplus) <= edge.second.all % 2;
  });
}

Points VolumeGradient(const Points& points, const Triangles& triangles) {
  const Eigen::RowVector3d origin = Origin(points);
  Points gradient = Points::Zero(points.rows(), 3);
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const Eigen::RowVector3d a = points.row(triangles(f, 0)) - origin;
    const Eigen::RowVector3d b = points.row(triangles(f, 1)) - origin;
    const Eigen::RowVector3d c = points.row(triangles(f, 2)) - origin;
    gradient.row(triangles(f, 0)) += b.cross(c) / 6;
    gradient.row(triangles(f, 1)) += c.cross(a) / 6;
    gradient.row(triangles(f, 2)) += a.cross(b) / 6;
  }
  return gradient;
}

Points VolumeGradientRate(const Points& points,
                          const Points& velocities,
                          const Triangles& triangles) {
  const Eigen::RowVector3d origin = Origin(points);
  const Eigen::RowVector3d origin_velocity = Origin(velocities);
  Points rate = Points::Zero(points.rows(), 3);
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    Eigen::RowVector3d p[3], v[3];
    for (int c = 0; c < 3; ++c) {
      p[c] = points.row(triangles(f, c)) - origin;
      v[c] = velocities.row(triangles(f, c)) - origin_velocity;
    }
    for (int c = 0; c < 3; ++c) {
      const int b = (c + 1) % 3, d = (c + 2) % 3;
      rate.row(triangles(f, c)) += (v[b].cross(p[d]) + p[b].cross(v[d])) / 6;
    }
  }
  return rate;
}

double SurfaceArea(const Points& points, const Triangles& triangles) {
  double area = 0;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    area += AreaOf(points, triangles, f);
  }
  return area;
}

double MeanCurvatureIntegral(const Points& points, const Triangles& triangles) {
  double integral = 0;
  for (const EdgeUses::Uses& uses : EdgeUses(triangles)) {
    if (uses.size() != 2) continue;
    const auto normal = [&](int half_edge) {
      return AreaVector(CornersOf(points, triangles.row(half_edge / 3)));
    };
    const Eigen::RowVector3d a = normal(uses[0]), b = normal(uses[1]);
    const Eigen::RowVector3d along = points.row(TargetOf(triangles, uses[0])) -
                                     points.row(OriginOf(triangles, uses[0]));
    const double length = along.norm();
    if (!(length > 0)) continue;
    integral +=
        length * std::atan2(a.cross(b).dot(along) / length, a.dot(b)) / 2;
  }
  return integral;
}

Eigen::VectorXd VertexAreas(const Points& points, const Triangles& triangles) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(points.rows());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const double third = AreaOf(points, triangles, f) / 3;
    for (const int v : triangles.row(f)) areas[v] += third;
  }
  return areas;
}

double TypicalEdge(const Points& points, const Triangles& triangles) {
  const double area =
      SurfaceArea(points, triangles) / static_cast<double>(triangles.rows());
  return std::sqrt(4 / std::sqrt(3.0) * area);
}

double BoundingBoxDiagonal(const Points& points) {
  if (points.rows() == 0) return 0;
  return (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

}  // namespace musclewarp
