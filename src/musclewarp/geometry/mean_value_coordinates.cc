// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/mean_value_coordinates.h"

#include <glog/logging.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace musclewarp {
namespace {

// A triangle of the cage. The two triangles of an edge share what is computed
// for it, with opposite signs.
struct CageFace {
  std::array<int, 3> vertices;
  std::array<int, 3> edges;  // edge k runs from vertex k to vertex k + 1
  std::array<double, 3> signs;
};

struct Cage {
  Points points;
  std::vector<std::array<int, 2>> edges;
  std::vector<CageFace> faces;
  double size = 0;                                       // mm
  Eigen::Matrix<double, Eigen::Dynamic, 4> homogeneous;  // #V x 4
  Eigen::LDLT<Eigen::Matrix4d> gram;  // homogeneous^T homogeneous
  Eigen::RowVector3d center;
};

Cage MakeCage(const Points& points, const Triangles& triangles) {
  Cage cage;
  cage.points = points;
  std::map<std::pair<int, int>, int> edge_index;
  for (Eigen::Index f = 0; f < triangles.rows(); ++f) {
    CageFace face;
    for (int k = 0; k < 3; ++k) {
      const int a = triangles(f, k);
      const int b = triangles(f, (k + 1) % 3);
      const auto [entry, is_new] =
          edge_index.try_emplace(std::minmax(a, b), cage.edges.size());
      if (is_new) cage.edges.push_back({std::min(a, b), std::max(a, b)});
      face.vertices[k] = a;
      face.edges[k] = entry->second;
      face.signs[k] = a < b ? 1 : -1;
    }
    cage.faces.push_back(face);
  }
  cage.center = points.colwise().mean();
  cage.size =
      (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  cage.homogeneous.resize(points.rows(), 4);
  cage.homogeneous.leftCols<3>() = (points.rowwise() - cage.center) / cage.size;
  cage.homogeneous.col(3).setOnes();
  cage.gram.compute(cage.homogeneous.transpose() * cage.homogeneous);
  return cage;
}

// The directions u from the query to the corners of a triangle span a height,
// their determinant over the largest cross product of two. If it is below this,
// the triangle is seen nearly edge on, or the query nearly touches it. Its
// weights are then small differences of large terms and need more digits.
constexpr double kThinHeight = 1e-6;
// If the height is below this in extended precision, the query lies on the
// triangle, or the triangle is a line as seen from it and has no weight.
constexpr double kFlatHeight = 1e-12;
// A query lies on a triangle if the sum of the angles of its edges differs from
// 2 pi by less than kOnFaceAngle, and on a vertex if it is nearer to it than
// kOnVertexDistance times the size of the cage.
constexpr double kOnFaceAngle = 1e-9;
constexpr double kOnVertexDistance = 1e-15;

// Computes the weights of one query, before they are normalised, in the
// precision of Scalar.
template <typename Scalar>
class WeightEvaluator {
 public:
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  using Weights = Eigen::Matrix<Scalar, 1, Eigen::Dynamic>;

  explicit WeightEvaluator(const Cage& cage)
      : cage_(cage),
        directions_(cage.points.rows()),
        distances_(cage.points.rows()),
        angles_(cage.edges.size()),
        edge_vectors_(cage.edges.size()),
        weights_(cage.points.rows()) {}

  const Weights& weights() const { return weights_; }

  // Returns false if the precision is not sufficient for `query`.
  bool Evaluate(const Eigen::RowVector3d& query) {
    weights_.setZero();
    if (LookAtVertices(query)) return true;
    LookAtEdges();
    for (const CageFace& face : cage_.faces) {
      switch (AddFace(face)) {
        case FaceResult::kAdded:
          break;
        case FaceResult::kQueryIsOnIt:
          SetBarycentric(face);
          return true;
        case FaceResult::kTooThin:
          return false;
      }
    }
    return true;
  }

 private:
  enum class FaceResult { kAdded, kQueryIsOnIt, kTooThin };

  // Returns true if the query is a vertex, whose weight is then set.
  bool LookAtVertices(const Eigen::RowVector3d& query) {
    const Vector x = query.transpose().template cast<Scalar>();
    for (Eigen::Index j = 0; j < cage_.points.rows(); ++j) {
      const Vector to_vertex =
          cage_.points.row(j).transpose().template cast<Scalar>() - x;
      distances_[j] = to_vertex.norm();
      if (distances_[j] <= kOnVertexDistance * cage_.size) {
        weights_[j] = 1;
        return true;
      }
      directions_[j] = to_vertex / distances_[j];
    }
    return false;
  }

  // Computes the angle theta of every edge, and theta times the unit normal of
  // the plane of the edge and the query.
  void LookAtEdges() {
    for (size_t e = 0; e < cage_.edges.size(); ++e) {
      const Vector& a = directions_[cage_.edges[e][0]];
      const Vector& b = directions_[cage_.edges[e][1]];
      const Vector normal = a.cross(b);
      const Scalar sine = normal.norm();
      angles_[e] = std::atan2(sine, a.dot(b));
      const Scalar scale = sine > 0 ? angles_[e] / sine : Scalar(0);
      edge_vectors_[e] = scale * normal;
    }
  }

  // The mean vector of the spherical triangle, m = 1/2 sum theta_e n_e, is the
  // combination of its corners u with weights by Cramer's rule.
  FaceResult AddFace(const CageFace& face) {
    const auto [i, j, k] = face.vertices;
    const Vector jk = directions_[j].cross(directions_[k]);
    const Vector ki = directions_[k].cross(directions_[i]);
    const Vector ij = directions_[i].cross(directions_[j]);
    const Scalar determinant = directions_[i].dot(jk);
    const Scalar squared_sine =
        std::max({jk.squaredNorm(), ki.squaredNorm(), ij.squaredNorm()});
    constexpr bool kIsDouble = std::is_same_v<Scalar, double>;
    constexpr Scalar kHeight = kIsDouble ? kThinHeight : kFlatHeight;
    if (determinant * determinant <= kHeight * kHeight * squared_sine) {
      if (kIsDouble) return FaceResult::kTooThin;
      const Scalar around = angles_[face.edges[0]] + angles_[face.edges[1]] +
                            angles_[face.edges[2]];
      return around > 2 * M_PIl - kOnFaceAngle ? FaceResult::kQueryIsOnIt
                                               : FaceResult::kAdded;
    }
    Vector mean = Vector::Zero();
    for (int e = 0; e < 3; ++e) {
      mean += Scalar(face.signs[e] / 2) * edge_vectors_[face.edges[e]];
    }
    weights_[i] += jk.dot(mean) / (determinant * distances_[i]);
    weights_[j] += ki.dot(mean) / (determinant * distances_[j]);
    weights_[k] += ij.dot(mean) / (determinant * distances_[k]);
    return FaceResult::kAdded;
  }

  // The query lies in the triangle: a corner weighs as the triangle that the
  // query makes with the other two.
  void SetBarycentric(const CageFace& face) {
    weights_.setZero();
    const auto opposite_area = [&](int b, int c) {
      return distances_[b] * distances_[c] *
             directions_[b].cross(directions_[c]).norm();
    };
    const auto [i, j, k] = face.vertices;
    weights_[i] = opposite_area(j, k);
    weights_[j] = opposite_area(k, i);
    weights_[k] = opposite_area(i, j);
  }

  const Cage& cage_;
  std::vector<Vector> directions_;
  std::vector<Scalar> distances_;
  std::vector<Scalar> angles_;
  std::vector<Vector> edge_vectors_;
  Weights weights_;
};

// Removes the rounding errors of the sum and of the reproduced query by the
// smallest change of the coordinates that does so.
void Polish(const Cage& cage,
            const Eigen::RowVector3d& query,
            Eigen::Ref<Eigen::RowVectorXd> row) {
  Eigen::RowVector4d wanted;
  wanted << (query - cage.center) / cage.size, 1;
  const Eigen::RowVector4d residual = wanted - row * cage.homogeneous;
  row += cage.gram.solve(residual.transpose()).transpose() *
         cage.homogeneous.transpose();
}

}  // namespace

RowMajorMatrix MeanValueCoordinates(const Points& queries,
                                    const Points& cage_points,
                                    const Triangles& cage_triangles) {
  CHECK_GE(cage_points.rows(), 4);
  const Cage cage = MakeCage(cage_points, cage_triangles);
  CHECK(cage.gram.vectorD().minCoeff() > 0) << "the cage is flat";
  RowMajorMatrix coordinates(queries.rows(), cage_points.rows());
#pragma omp parallel
  {
    WeightEvaluator<double> evaluator(cage);
    WeightEvaluator<long double> precise_evaluator(cage);
#pragma omp for schedule(dynamic, 64)
    for (Eigen::Index q = 0; q < queries.rows(); ++q) {
      const Eigen::RowVector3d query = queries.row(q);
      if (evaluator.Evaluate(query)) {
        coordinates.row(q) = evaluator.weights() / evaluator.weights().sum();
      } else {
        CHECK(precise_evaluator.Evaluate(query));
        const auto& weights = precise_evaluator.weights();
        coordinates.row(q) = (weights / weights.sum()).cast<double>();
      }
      Polish(cage, query, coordinates.row(q));
    }
  }
  return coordinates;
}

}  // namespace musclewarp
