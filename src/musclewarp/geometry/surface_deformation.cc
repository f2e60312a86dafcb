// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/surface_deformation.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
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

// Returns the angle between two normals (rad), negative if the surface is
// concave along the edge from the first to the second.
double AngleBetween(const Eigen::RowVector3d& a,
                    const Eigen::RowVector3d& b,
                    const Eigen::RowVector3d& edge) {
  const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
  return (b - a).dot(edge) < 0 ? -angle : angle;
}

// Sets the stretches of a vertex whose deformation gradient F has `squares` =
// F^T F. Its eigenvalues are the squares of the singular values of F.
void SetStretches(const Eigen::Matrix2d& squares,
                  bool has_course,
                  Eigen::Index vertex,
                  SurfaceDeformation* result) {
  const double spread =
      std::hypot((squares(0, 0) - squares(1, 1)) / 2, squares(0, 1));
  result->largest_stretch[vertex] = std::sqrt(squares.trace() / 2 + spread);
  result->area_ratio[vertex] = std::sqrt(std::max(0.0, squares.determinant()));
  if (!has_course) return;
  result->stretch_along[vertex] = std::sqrt(squares(0, 0));
  result->stretch_across[vertex] = std::sqrt(squares(1, 1));
}

// True unless edges with the sum `squares` of (edge) (edge)^T in a plane lie
// almost on one line.
bool AreSpread(const Eigen::Matrix2d& squares) {
  const double trace = squares.trace();
  return trace > 0 &&
         squares.determinant() > kLeastSpread * kLeastSpread * trace * trace;
}

}  // namespace

SurfaceAtRest::SurfaceAtRest(const Points& points,
                             const Triangles& triangles,
                             const Points& course)
    : points_(points), triangles_(triangles) {
  CHECK(course.rows() == 0 || course.rows() == points.rows());
  FindNeighbours();
  const Points normals = VertexNormals(points_, triangles_);
  FitGradients(normals, course);
  angles_.resize(neighbours_.size());
  for (Eigen::Index v = 0; v < points_.rows(); ++v) {
    for (int k = first_[v]; k < first_[v + 1]; ++k) {
      const int w = neighbours_[k];
      angles_[k] = AngleBetween(
          normals.row(v), normals.row(w), points_.row(w) - points_.row(v));
    }
  }
}

void SurfaceAtRest::FindNeighbours() {
  std::vector<std::pair<int, int>> edges;  // both ways, once for each triangle
  edges.reserve(6 * triangles_.rows());
  for (Eigen::Index f = 0; f < triangles_.rows(); ++f) {
    for (int corner = 0; corner < 3; ++corner) {
      const int v = triangles_(f, corner);
      const int w = triangles_(f, (corner + 1) % 3);
      edges.emplace_back(v, w);
      edges.emplace_back(w, v);
    }
  }
  std::sort(edges.begin(), edges.end());
  first_.assign(points_.rows() + 1, 0);
  for (size_t i = 0; i < edges.size(); ++i) {
    if (i > 0 && edges[i] == edges[i - 1]) {
      ++num_triangles_.back();
      continue;
    }
    neighbours_.push_back(edges[i].second);
    num_triangles_.push_back(1);
    ++first_[edges[i].first + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

void SurfaceAtRest::FitGradients(const Points& normals, const Points& course) {
  shares_.assign(neighbours_.size(), PlaneVector::Zero());
  has_gradient_.assign(points_.rows(), false);
  has_course_.assign(points_.rows(), false);
  for (Eigen::Index v = 0; v < points_.rows(); ++v) {
    const bool has_course = course.rows() > 0 && !course.row(v).isZero();
    const PlaneBasis basis =
        TangentBasis(normals.row(v).transpose(),
                     has_course ? Eigen::Vector3d(course.row(v).transpose())
                                : Eigen::Vector3d(Eigen::Vector3d::Zero()));
    const auto edge = [&](int k) -> PlaneVector {
      return basis.transpose() *
             (points_.row(neighbours_[k]) - points_.row(v)).transpose();
    };
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (int k = first_[v]; k < first_[v + 1]; ++k) {
      squares += num_triangles_[k] * edge(k) * edge(k).transpose();
    }
    has_course_[v] = has_course;
    has_gradient_[v] = AreSpread(squares);
    if (!has_gradient_[v]) continue;
    const Eigen::Matrix2d inverse = squares.inverse();
    for (int k = first_[v]; k < first_[v + 1]; ++k) {
      shares_[k] = num_triangles_[k] * (inverse * edge(k));
    }
  }
}

SurfaceAtRest::Gradient SurfaceAtRest::GradientAt(
    Eigen::Index v, const Points& deformed) const {
  Gradient gradient = Gradient::Zero();
  for (int k = first_[v]; k < first_[v + 1]; ++k) {
    const Eigen::RowVector3d edge =
        deformed.row(neighbours_[k]) - deformed.row(v);
    gradient += edge.transpose() * shares_[k].transpose();
  }
  return gradient;
}

Eigen::VectorXd SurfaceAtRest::Bends(const Points& deformed,
                                     const Points& normals) const {
  Eigen::VectorXd bends = Eigen::VectorXd::Zero(points_.rows());
  for (Eigen::Index v = 0; v < points_.rows(); ++v) {
    for (int k = first_[v]; k < first_[v + 1]; ++k) {
      const int w = neighbours_[k];
      if (w < v) continue;  // The angle is the same from either end.
      const double change =
          std::abs(AngleBetween(normals.row(v),
                                normals.row(w),
                                deformed.row(w) - deformed.row(v)) -
                   angles_[k]);
      bends[v] = std::max(bends[v], change);
      bends[w] = std::max(bends[w], change);
    }
  }
  return bends;
}

SurfaceDeformation SurfaceAtRest::Measure(const Points& deformed) const {
  CHECK_EQ(deformed.rows(), points_.rows());
  const Points normals = VertexNormals(deformed, triangles_);
  SurfaceDeformation result;
  result.largest_stretch = Eigen::VectorXd::Ones(points_.rows());
  result.stretch_along = result.largest_stretch;
  result.stretch_across = result.largest_stretch;
  result.area_ratio = result.largest_stretch;
  for (Eigen::Index v = 0; v < points_.rows(); ++v) {
    if (!has_gradient_[v]) continue;
    const Gradient gradient = GradientAt(v, deformed);
    // In the tangent plane only.
    const Eigen::RowVector2d out = normals.row(v) * gradient;
    SetStretches(gradient.transpose() * gradient - out.transpose() * out,
                 has_course_[v],
                 v,
                 &result);
  }
  result.bend = Bends(deformed, normals);
  return result;
}

}  // namespace musclewarp
