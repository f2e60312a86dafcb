// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/SparseCore>
#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A sparse matrix whose rows are contiguous, so that a product with a vector
// reads the matrix in the order in which it is stored.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// How much each row of a Laplacian weighs.
enum class LaplacianWeights {
  // By the area around its vertex. The energy 1/2 |L X|^2 then approaches
  // 1/2 l^2 times the integral of |laplace x|^2 over the surface as the mesh
  // becomes finer, with the length scale l.
  kArea,

  // Rows are divided by the sums of their weights (paper, eq. 2.2). The energy
  // then falls with the square of the length of the edges, and a finer mesh is
  // a softer one.
  kPaper,
};

// "area" or "paper": the text of flags.
std::string ToString(LaplacianWeights weights);

// The options of CotangentLaplacian. The defaults suit muscle hulls of some
// hundred vertices.
struct CotangentLaplacianOptions {
  LaplacianWeights weights = LaplacianWeights::kArea;

  // With kArea, the length scale l of the surface's stiffness, mm: the larger,
  // the stiffer. 0: sqrt(A / 2400), where A is the area of the surface, with
  // which a mesh of 200 even vertices has the energy that kPaper gives it.
  double length_scale = 0;

  // With kArea, no vertex counts with less than this fraction of the mean area.
  // Slivers would make it stiff beyond measure.
  double min_area = 0.05;

  // No cotangent is larger in size than that of this angle, rad. An angle
  // nearer to 0 or pi belongs to a sliver, whose cotangent would outweigh the
  // rest of the mesh.
  double min_angle = 0.05;

  // No weight w_ij is smaller than this, so that every row sum is positive.
  // Pairs of obtuse triangles have negative cotangent sums, which can cancel a
  // row.
  double min_weight = 0.05;

  // Returns false and names the field, its value and the rule if a field is out
  // of range.
  bool IsValid(std::string* error) const;
};

// Returns the length scale l of the rows, mm: their squares add up to l^2 times
// the integral of |laplace x|^2 over the surface, with kPaper if its triangles
// are even. Precondition (CHECKed): the options are valid.
double LengthScale(const Points& points,
                   const Triangles& triangles,
                   const CotangentLaplacianOptions& options);

// Returns the discrete Laplacian L (#V x #V) of a triangle mesh, which measures
// how a vertex lies relative to its neighbours. Keeping L X keeps the shape of
// the surface while the mesh is deformed (paper, eq. 2.1 to 2.3):
//
//   (L X)_i = sum_j w_ij (x_j - x_i),   w_ij = cot a_ij + cot b_ij,
//
// where a_ij and b_ij are the angles opposite to the edge ij. The diagonal is
// minus the sum of the other entries of the row, so that constants are in the
// null space. Rows are then weighted:
//
//   kArea    by l / (2 sqrt(a_i)), where a_i is a third of the area of the
//            triangles at vertex i, as laplace x is 1 / (2 a_i) times the sum;
//   kPaper   by 1 / sum_j w_ij.
//
// Either way (L X)_i has the unit of X, and L is not symmetric. A vertex
// without triangles has an empty row.
//
// `points` is #V x 3 and `triangles` #F x 3. Precondition (CHECKed): the
// options are valid.
SparseMatrix CotangentLaplacian(const Points& points,
                                const Triangles& triangles,
                                const CotangentLaplacianOptions& options);

}  // namespace musclewarp
