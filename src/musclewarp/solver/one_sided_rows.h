// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/half_space.h"
#include "musclewarp/solver/muscle_model.h"

namespace musclewarp {

// One-sided rows of the energy, beside the rows of the linear energy. Each asks
// softly that a fine vertex v(k) lies in the half-space n_k . p >= level_k:
//
//   r_k = weight max(0, level_k - n_k . (W X)_v(k)),   K residuals.
//
// A row is active, that is, not zero, while its vertex lies on the wrong side
// of its plane. Without rows (K = 0) the energy is the linear one. Certified
// contact asks for such rows (docs/method.md); the solver does not need to know
// where the half-spaces come from.
struct OneSidedRows {
  std::vector<int> vertices;  // K: v(k), indices of fine vertices
  Points normals;             // K x 3: n_k, of unit length
  Eigen::VectorXd levels;     // K, mm
  double weight = 1;          // the same for all rows

  int size() const { return static_cast<int>(vertices.size()); }
};

// Returns the rows for `planes`, in their order. A vertex may have several.
OneSidedRows OneSidedRowsOf(const std::vector<VertexHalfSpace>& planes,
                            double weight);

// Returns the rows of W that belong to the vertices of `rows`, K x N.
RowMajorMatrix FineFromCoarse(const MuscleModel& model,
                              const OneSidedRows& rows);

// Returns how deep each vertex lies on the wrong side of its plane,
// level_k - n_k . (W X)_v(k), K, mm. The depth is negative on the right side.
// `fine_from_coarse` is what FineFromCoarse returned, `coarse` is X (N x 3,
// mm).
Eigen::VectorXd OneSidedDepths(const OneSidedRows& rows,
                               const RowMajorMatrix& fine_from_coarse,
                               const Points& coarse);

// Returns the direction in which the energy of the rows falls most steeply,
// for vertices that are `depths` deep: N x 3.
Points OneSidedDescent(const OneSidedRows& rows,
                       const RowMajorMatrix& fine_from_coarse,
                       const Eigen::VectorXd& depths);

// Solves with the Gauss-Newton matrix of the energy that includes the active
// one-sided rows,
//
//   A' = A (on x, y and z) + weight^2 sum_active (W_v^T n)(W_v^T n)^T,
//
// 3N x 3N: a row couples x, y and z. A' is never formed. Each active row adds
// rank one, so the Woodbury identity corrects solutions with the factorised A
// by a system as small as the number of active rows.
//
//   OneSidedSystem system(model, rows);
//   system.UpdateActiveRows(coarse);
//   step = system.CorrectedStep(minimizer - coarse);
class OneSidedSystem {
 public:
  // Keeps references to both arguments. Costs one solve with A per row.
  OneSidedSystem(const MuscleModel& model, const OneSidedRows& rows);

  // Selects the rows that are active at `coarse` (N x 3, mm) and factorises the
  // small system. The functions below refer to the last call.
  void UpdateActiveRows(const Points& coarse);

  // The rows of W of FineFromCoarse(), and OneSidedDepths() at `coarse`.
  const RowMajorMatrix& fine_from_coarse() const { return fine_from_coarse_; }
  const Eigen::VectorXd& depths() const { return depths_; }

  // Returns A'^-1 b for the `solution` A^-1 b (N x 3).
  Points CorrectedSolution(Points solution) const;

  // Returns the Gauss-Newton step of the whole energy, N x 3, mm, for the
  // step X* - X of the linear energy alone.
  Points CorrectedStep(const Points& linear_step) const;

 private:
  const OneSidedRows& rows_;
  RowMajorMatrix fine_from_coarse_;  // K x N
  RowMajorMatrix compliance_;        // K x N: W_v A^-1
  std::vector<int> active_;          // indices of rows
  Eigen::VectorXd depths_;           // of all rows, mm
  Eigen::LLT<Eigen::MatrixXd> active_matrix_;
};

}  // namespace musclewarp
