// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/fine_map.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "musclewarp/base/work_counts.h"
#include "musclewarp/geometry/row_products.h"

namespace musclewarp {
namespace {

// Returns four points (N x 3) that span space well: each is the farthest from
// what those before it span.
std::vector<int> SpreadFour(const Points& points) {
  Points left = points.rowwise() - points.colwise().mean();
  std::vector<int> chosen;
  for (int k = 0; k < 4; ++k) {
    Eigen::Index farthest;
    left.rowwise().squaredNorm().maxCoeff(&farthest);
    chosen.push_back(static_cast<int>(farthest));
    if (k == 0) {
      left = points.rowwise() - points.row(farthest);
    } else {
      const Eigen::RowVector3d way = left.row(farthest).stableNormalized();
      left -= (left * way.transpose() * way).eval();
    }
  }
  return chosen;
}

// Affine coordinates about the centre of `coarse`: P x 4.
Eigen::MatrixX4d Affine(const Points& points, const Points& coarse) {
  Eigen::MatrixX4d affine(points.rows(), 4);
  affine << Eigen::VectorXd::Ones(points.rows()),
      points.rowwise() - coarse.colwise().mean();
  return affine;
}

}  // namespace

FineMap MakeFineMap(const RowMajorMatrix& matrix, const Points& coarse) {
  CHECK_EQ(matrix.cols(), coarse.rows());
  CHECK_GE(coarse.rows(), 4);
  FineMap map;
  map.weights = matrix.cast<float>();
  map.corrected = SpreadFour(coarse);
  const Eigen::MatrixX4d affine = Affine(coarse, coarse);
  const Eigen::FullPivLU<Eigen::Matrix4d> four(
      affine(map.corrected, Eigen::all).transpose());
  map.corrections.resize(matrix.rows(), 4);
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::RowVectorXd rounding =
        matrix.row(i) - map.weights.row(i).cast<double>();
    const Eigen::Vector4d lost = (rounding * affine).transpose();
    map.corrections.row(i) = four.solve(lost).transpose();
  }
  return map;
}

RowMajorMatrix RowsOf(const FineMap& map, const std::vector<int>& rows) {
  RowMajorMatrix matrix = map.weights(rows, Eigen::all).cast<double>();
  for (int k = 0; k < 4; ++k) {
    matrix.col(map.corrected[k]) += map.corrections(rows, k);
  }
  return matrix;
}

Points Product(const FineMap& map, const Points& points) {
  return Products(map, {points})[0];
}

Points TransposedProduct(const FineMap& map, const Points& points) {
  return TransposedProducts(map, {points})[0];
}

std::vector<Points> Products(const FineMap& map,
                             const std::vector<Points>& sets) {
  std::vector<Eigen::MatrixX3d> columns;  // column-major
  std::vector<Points> products;
  for (const Points& points : sets) {
    CHECK_EQ(map.cols(), points.rows());
    columns.emplace_back(points);
    products.emplace_back(map.rows(), 3);
  }
  const auto multiply = [&](auto kernel) {
    return [&, kernel](Eigen::Index i) {
      for (size_t k = 0; k < sets.size(); ++k) {
        kernel(map.weights.row(i).data(),
               columns[k].data(),
               map.cols(),
               products[k].row(i).data());
      }
    };
  };
  ForRows(map.rows(), multiply(Dots<4, float>), multiply(Dots<1, float>));
  for (size_t k = 0; k < sets.size(); ++k) {
    products[k] += map.corrections * sets[k](map.corrected, Eigen::all);
  }
  CountWork(WorkUnit::kMatrixEntries, map.weights.size());
  return products;
}

std::vector<Points> TransposedProducts(const FineMap& map,
                                       const std::vector<Points>& sets) {
  std::vector<Eigen::MatrixX3d> sums;
  for (const Points& points : sets) {
    CHECK_EQ(map.rows(), points.rows());
    sums.push_back(Eigen::MatrixX3d::Zero(map.cols(), 3));
  }
  const auto add = [&](auto kernel) {
    return [&, kernel](Eigen::Index i) {
      for (size_t k = 0; k < sets.size(); ++k) {
        kernel(map.weights.row(i).data(),
               sets[k].row(i).data(),
               map.cols(),
               sums[k].data());
      }
    };
  };
  ForRows(map.rows(), add(AddRows<4, float>), add(AddRows<1, float>));
  for (size_t k = 0; k < sets.size(); ++k) {
    sums[k](map.corrected, Eigen::all) += map.corrections.transpose() * sets[k];
  }
  CountWork(WorkUnit::kMatrixEntries, map.weights.size());
  return {sums.begin(), sums.end()};
}

}  // namespace musclewarp
