// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/contact_rows.h"

#include <utility>

namespace musclewarp {

ContactRows ContactRowsOf(const MuscleModel& model,
                          const Points& free,
                          const Points& pushed,
                          const std::vector<char>& is_held,
                          double weight) {
  std::vector<int> farthest(model.coarse_rest.rows(), -1);
  const auto length = [&](int v) { return (pushed.row(v) - free.row(v)).norm(); };
  for (int v = 0; v < static_cast<int>(is_held.size()); ++v) {
    if (!is_held[v] || length(v) == 0) continue;
    Eigen::Index followed;
    model.fine_from_coarse.row(v).maxCoeff(&followed);
    int& chosen = farthest[followed];
    if (chosen < 0 || length(v) > length(chosen)) chosen = v;
  }
  ContactRows rows;
  rows.weight = weight;
  for (const int v : farthest) {
    if (v >= 0) rows.vertices.push_back(v);
  }
  rows.normals.resize(rows.size(), 3);
  rows.levels.resize(rows.size());
  for (int k = 0; k < rows.size(); ++k) {
    const int v = rows.vertices[k];
    rows.normals.row(k) = (pushed.row(v) - free.row(v)).normalized();
    rows.levels[k] = rows.normals.row(k).dot(pushed.row(v));
  }
  return rows;
}

RowMajorMatrix FineFromCoarse(const MuscleModel& model,
                              const ContactRows& rows) {
  return model.fine_from_coarse(rows.vertices, Eigen::all);
}

Eigen::VectorXd ContactDepths(const ContactRows& rows,
                              const RowMajorMatrix& fine_from_coarse,
                              const Points& coarse) {
  const Points places = fine_from_coarse * coarse;
  return rows.levels - rows.normals.cwiseProduct(places).rowwise().sum();
}

ContactSystem::ContactSystem(const MuscleModel& model, const ContactRows& rows)
    : rows_(rows),
      fine_from_coarse_(FineFromCoarse(model, rows)),
      compliance_(model.normal_matrix.solve(fine_from_coarse_.transpose())) {}

void ContactSystem::SetPlace(const Points& coarse) {
  depths_ = ContactDepths(rows_, fine_from_coarse_, coarse);
  active_.clear();
  for (int k = 0; k < rows_.size(); ++k) {
    if (depths_[k] > 0) active_.push_back(k);
  }
  const Points normals = rows_.normals(active_, Eigen::all);
  Eigen::MatrixXd matrix =
      (fine_from_coarse_(active_, Eigen::all) *
       compliance_(Eigen::all, active_))
          .cwiseProduct(normals * normals.transpose());
  matrix.diagonal().array() += 1 / (rows_.weight * rows_.weight);
  active_matrix_.compute(matrix);
}

Points ContactSystem::Corrected(Points solved) const {
  if (active_.empty()) return solved;
  const Points normals = rows_.normals(active_, Eigen::all);
  const Points moves = fine_from_coarse_(active_, Eigen::all) * solved;
  const Eigen::VectorXd forces = active_matrix_.solve(
      normals.cwiseProduct(moves).rowwise().sum().eval());
  solved -= compliance_(Eigen::all, active_) * (forces.asDiagonal() * normals);
  return solved;
}

Points ContactSystem::StepOf(const Points& step_without) const {
  if (active_.empty()) return step_without;
  const Eigen::VectorXd forces =
      rows_.weight * rows_.weight * depths_(active_);
  const Points normals = rows_.normals(active_, Eigen::all);
  return Corrected(step_without + compliance_(Eigen::all, active_) *
                                      (forces.asDiagonal() * normals));
}

}  // namespace musclewarp
