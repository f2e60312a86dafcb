// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frames/surface_deformation.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

namespace musclewarp {
namespace {

using PlaneBasis = Eigen::Matrix<double, 3, 2>;

// Edges count as lying on one line if they spread across it by less than this
// part of what they spread along it.
constexpr double kLeastSpread = 1e-3;

// Normals of vertices, weighted by the areas of their triangles, #V x 3, of
// unit length or zero.
Points VertexNormals(const Points& points, const Triangles& triangles) {
  Points normals = Points::Zero(points.rows(), 3);
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    const Eigen::RowVector3d a = points.row(triangles(f, 0));
    const Eigen::RowVector3d b = points.row(triangles(f, 1));
    const Eigen::RowVector3d c = points.row(triangles(f, 2));
    const Eigen::RowVector3d normal = (b - a).cross(c - a);
    for (int corner = 0; corner < 3; ++corner) {
      normals.row(triangles(f, corner)) += normal;
    }
  }
  normals.rowwise().normalize();
  return normals;
}

// An orthonormal basis of the tangent plane at a vertex. Its first column is
// along the course of the muscle if that has a direction there.
PlaneBasis TangentBasis(const Eigen::Vector3d& normal,
                        const Eigen::Vector3d& course) {
  Eigen::Vector3d along = course - course.dot(normal) * normal;
  if (!(along.norm() > kLeastSpread * course.norm())) {
    along = normal.unitOrthogonal();
  }
  along.normalize();
  PlaneBasis basis;
  basis << along, normal.cross(along);
  return basis;
}

// What a least squares fit of the gradient of a vertex needs: over its edges in
// the tangent planes, the sums of (rest edge) (rest edge)^T and of (deformed
// edge) (rest edge)^T.
struct EdgeSums {
  Eigen::Matrix2d rest = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d deformed = Eigen::Matrix2d::Zero();

  void Add(const Eigen::Vector2d& rest_edge, const Eigen::Vector2d& edge) {
    rest += rest_edge * rest_edge.transpose();
    deformed += edge * rest_edge.transpose();
  }

  bool IsSpread() const {
    const double trace = rest.trace();
    return trace > 0 &&
           rest.determinant() > kLeastSpread * kLeastSpread * trace * trace;
  }
};

std::vector<PlaneBasis> TangentBases(const Points& normals,
                                     const Points& course) {
  std::vector<PlaneBasis> bases(normals.rows());
  for (Eigen::Index v = 0; v < normals.rows(); ++v) {
    bases[v] =
        TangentBasis(normals.row(v).transpose(),
                     course.rows() == 0 ? Eigen::Vector3d::Zero()
                                        : course.row(v).transpose().eval());
  }
  return bases;
}

std::vector<EdgeSums> SumEdges(const Points& rest,
                               const std::vector<PlaneBasis>& rest_bases,
                               const Points& deformed,
                               const std::vector<PlaneBasis>& bases,
                               const Triangles& triangles) {
  std::vector<EdgeSums> sums(rest.rows());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const int v = triangles(f, corner);
      for (const int other : {(corner + 1) % 3, (corner + 2) % 3}) {
        const int w = triangles(f, other);
        const Eigen::RowVector3d rest_edge = rest.row(w) - rest.row(v);
        const Eigen::RowVector3d edge = deformed.row(w) - deformed.row(v);
        sums[v].Add((rest_edge * rest_bases[v]).transpose(),
                    (edge * bases[v]).transpose());
      }
    }
  }
  return sums;
}

// Returns the angle between two normals (rad), negative if the surface is
// concave along the edge from the first to the second.
double AngleBetween(const Eigen::RowVector3d& a,
                    const Eigen::RowVector3d& b,
                    const Eigen::RowVector3d& edge) {
  const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
  return (b - a).dot(edge) < 0 ? -angle : angle;
}

void SetStretches(const Eigen::Matrix2d& gradient,
                  bool has_course,
                  Eigen::Index vertex,
                  SurfaceDeformation* result) {
  // The eigenvalues of F^T F are the squares of the singular values of F.
  const Eigen::Matrix2d squares = gradient.transpose() * gradient;
  const double spread =
      std::hypot((squares(0, 0) - squares(1, 1)) / 2, squares(0, 1));
  result->largest_stretch[vertex] = std::sqrt(squares.trace() / 2 + spread);
  result->area_ratio[vertex] = std::abs(gradient.determinant());
  if (!has_course) return;
  result->stretch_along[vertex] = gradient.col(0).norm();
  result->stretch_across[vertex] = gradient.col(1).norm();
}

Eigen::VectorXd Bends(const Points& rest,
                      const Points& rest_normals,
                      const Points& deformed,
                      const Points& normals,
                      const Triangles& triangles) {
  Eigen::VectorXd bends = Eigen::VectorXd::Zero(rest.rows());
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const int a = triangles(f, corner);
      const int b = triangles(f, (corner + 1) % 3);
      const double change =
          std::abs(AngleBetween(normals.row(a),
                                normals.row(b),
                                deformed.row(b) - deformed.row(a)) -
                   AngleBetween(rest_normals.row(a),
                                rest_normals.row(b),
                                rest.row(b) - rest.row(a)));
      bends[a] = std::max(bends[a], change);
      bends[b] = std::max(bends[b], change);
    }
  }
  return bends;
}

}  // namespace

SurfaceDeformation MeasureSurfaceDeformation(const Points& rest,
                                             const Points& deformed,
                                             const Triangles& triangles,
                                             const Points& course) {
  CHECK_EQ(rest.rows(), deformed.rows());
  CHECK(course.rows() == 0 || course.rows() == rest.rows());
  const Eigen::Index count = rest.rows();
  const Points rest_normals = VertexNormals(rest, triangles);
  const Points normals = VertexNormals(deformed, triangles);
  const std::vector<EdgeSums> sums =
      SumEdges(rest,
               TangentBases(rest_normals, course),
               deformed,
               TangentBases(normals, Points()),
               triangles);
  SurfaceDeformation result;
  result.largest_stretch = Eigen::VectorXd::Ones(count);
  result.stretch_along = result.largest_stretch;
  result.stretch_across = result.largest_stretch;
  result.area_ratio = result.largest_stretch;
  for (Eigen::Index v = 0; v < count; ++v) {
    if (!sums[v].IsSpread()) continue;
    SetStretches(sums[v].deformed * sums[v].rest.inverse(),
                 course.rows() > 0 && !course.row(v).isZero(),
                 v,
                 &result);
  }
  result.bend = Bends(rest, rest_normals, deformed, normals, triangles);
  return result;
}

}  // namespace musclewarp
