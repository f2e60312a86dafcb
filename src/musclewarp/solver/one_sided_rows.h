// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/geometry/half_space.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

// Fine vertices of a muscle that should lie beyond planes, as one-sided rows
// beside those of the linear energy:
//
//   r_k = weight max(0, level_k - n_k . (W X)_v(k)),   K residuals.
//
// Contact asks for them (docs/method.md); without rows there are none.
struct OneSidedRows {
  std::vector<int> vertices;  // v, of the fine mesh
  Points normals;             // K x 3, of length 1
  Eigen::VectorXd levels;     // K, mm
  double weight = 1;

  int size() const { return static_cast<int>(vertices.size()); }
};

OneSidedRows OneSidedRowsOf(const std::vector<VertexHalfSpace>& planes,
                            double weight);

// The rows of W of the vertices, K x N.
RowMajorMatrix FineFromCoarse(const MuscleModel& model,
                              const OneSidedRows& rows);

// By how much the vertices lie on the wrong side of their planes, K, mm; below
// zero where they are beyond.
Eigen::VectorXd OneSidedDepths(const OneSidedRows& rows,
                               const RowMajorMatrix& fine_from_coarse,
                               const Points& coarse);

// The matrix that steps with one-sided rows have to solve with in place of A:
//
//   A' = A (on x, y and z) + weight^2 sum_active (W_v^T n)(W_v^T n)^T,
//
// of rank one more for each row that is active, that is, a vertex on the wrong
// side of its plane. Solved by the Woodbury identity.
class OneSidedSystem {
 public:
  // Keeps references.
  OneSidedSystem(const MuscleModel& model, const OneSidedRows& rows);

  // Chooses what is active at `coarse` (N x 3).
  void SetPlace(const Points& coarse);

  // A'^-1 b, of A^-1 b (N x 3).
  Points Corrected(Points solved) const;

  // The step to the minimum of the energy with what is active, of that without
  // contact, N x 3.
  Points StepOf(const Points& step_without) const;

 private:
  const OneSidedRows& rows_;
  RowMajorMatrix fine_from_coarse_;  // K x N
  Eigen::MatrixXd compliance_;       // N x K: A^-1 W_v^T
  std::vector<int> active_;
  Eigen::VectorXd depths_;  // of all rows
  Eigen::LLT<Eigen::MatrixXd> active_matrix_;
};

}  // namespace musclewarp
