// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/one_sided_rows.h"

#include <utility>

#include "musclewarp/geometry/thin_product.h"

namespace musclewarp {

OneSidedRows OneSidedRowsOf(const std::vector<VertexHalfSpace>& planes,
                            double weight) {
  OneSidedRows rows;
  rows.weight = weight;
  rows.normals.resize(planes.size(), 3);
  rows.levels.resize(planes.size());
  for (const VertexHalfSpace& plane : planes) {
    rows.normals.row(rows.size()) = plane.space.normal;
    rows.levels[rows.size()] = plane.space.level;
    rows.vertices.push_back(plane.vertex);
  }
  return rows;
}

RowMajorMatrix FineFromCoarse(const MuscleModel& model,
                              const OneSidedRows& rows) {
  return RowsOf(model.fine_from_coarse, rows.vertices);
}

Eigen::VectorXd OneSidedDepths(const OneSidedRows& rows,
                               const RowMajorMatrix& fine_from_coarse,
                               const Points& coarse) {
  const Points places = ThinProduct(fine_from_coarse, coarse);
  return rows.levels - rows.normals.cwiseProduct(places).rowwise().sum();
}

Points OneSidedDescent(const OneSidedRows& rows,
                       const RowMajorMatrix& fine_from_coarse,
                       const Eigen::VectorXd& depths) {
  return rows.weight * rows.weight *
         ThinTransposedProduct(fine_from_coarse,
                               depths.cwiseMax(0).asDiagonal() * rows.normals);
}

OneSidedSystem::OneSidedSystem(const MuscleModel& model,
                               const OneSidedRows& rows)
    : rows_(rows),
      fine_from_coarse_(FineFromCoarse(model, rows)),
      compliance_(model.normal_matrix.solve(fine_from_coarse_.transpose())
                      .transpose()) {}

void OneSidedSystem::UpdateActiveRows(const Points& coarse) {
  depths_ = OneSidedDepths(rows_, fine_from_coarse_, coarse);
  active_.clear();
  for (int k = 0; k < rows_.size(); ++k) {
    if (depths_[k] > 0) active_.push_back(k);
  }
  if (active_.empty()) return;
  const Points normals = rows_.normals(active_, Eigen::all);
  Eigen::MatrixXd matrix = (fine_from_coarse_(active_, Eigen::all) *
                            compliance_(active_, Eigen::all).transpose())
                               .cwiseProduct(normals * normals.transpose());
  matrix.diagonal().array() += 1 / (rows_.weight * rows_.weight);
  active_matrix_.compute(matrix);
}

Points OneSidedSystem::CorrectedSolution(Points solved) const {
  if (active_.empty()) return solved;
  const Points normals = rows_.normals(active_, Eigen::all);
  const Points moves = ThinProduct(fine_from_coarse_, active_, solved);
  const Eigen::VectorXd forces =
      active_matrix_.solve(normals.cwiseProduct(moves).rowwise().sum().eval());
  solved -= ThinTransposedProduct(
      compliance_, active_, forces.asDiagonal() * normals);
  return solved;
}

Points OneSidedSystem::CorrectedStep(const Points& step_without) const {
  if (active_.empty()) return step_without;
  const Eigen::VectorXd forces = rows_.weight * rows_.weight * depths_(active_);
  const Points normals = rows_.normals(active_, Eigen::all);
  return CorrectedSolution(
      step_without + ThinTransposedProduct(
                         compliance_, active_, forces.asDiagonal() * normals));
}

}  // namespace musclewarp
