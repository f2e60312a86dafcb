// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/single_muscle_problem.h"

#include <vector>

#include "problems/single_muscle/coordinates_term.h"
#include "problems/single_muscle/laplacian_term.h"
#include "problems/single_muscle/volume_term.h"
#include "problems/single_muscle/whitened_linear_term.h"

namespace musclewarp {
namespace {

std::vector<double*> RowBlocks(Points* points) {
  std::vector<double*> blocks(points->rows());
  for (size_t i = 0; i < blocks.size(); ++i) {
    blocks[i] = points->data() + 3 * i;
  }
  return blocks;
}

void AddLaplacianTerms(const MuscleModel& model,
                       const MuscleTarget& target,
                       const std::vector<double*>& vertices,
                       ceres::Problem* problem) {
  for (int i = 0; i < model.laplacian.outerSize(); ++i) {
    std::vector<double> weights;
    std::vector<double*> blocks = {vertices[i]};
    for (SparseMatrix::InnerIterator entry(model.laplacian, i); entry;
         ++entry) {
      if (entry.col() == i) continue;
      weights.push_back(entry.value());
      blocks.push_back(vertices[entry.col()]);
    }
    problem->AddResidualBlock(
        LaplacianTerm::Create(std::move(weights),
                              target.laplacian.row(i).data()),
        nullptr,
        blocks);
  }
}

void AddCoordinatesTerms(const RowMajorMatrix& rows,
                         const Points& targets,
                         const std::vector<double*>& vertices,
                         ceres::Problem* problem) {
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    problem->AddResidualBlock(
        CoordinatesTerm::Create(rows.row(i), targets.row(i).data()),
        nullptr,
        vertices);
  }
}

}  // namespace

void AddMuscleInBlocks(const MuscleModel& model,
                       const MuscleTarget& target,
                       const HardConstraint& constraint,
                       Points* coarse,
                       ceres::Problem* problem) {
  const std::vector<double*> vertices = RowBlocks(coarse);
  AddLaplacianTerms(model, target, vertices, problem);
  AddCoordinatesTerms(model.skeleton, target.skeleton, vertices, problem);
  AddCoordinatesTerms(model.attachment, target.attachment, vertices, problem);
  problem->AddResidualBlock(
      new VolumeTerm(&model, &constraint, nullptr), nullptr, vertices);
}

void AddMuscleWhitened(const MuscleModel& model,
                       const Whitening& whitening,
                       const HardConstraint& constraint,
                       Points* whitened,
                       ceres::Problem* problem) {
  const std::vector<double*> unknowns = RowBlocks(whitened);
  for (double* unknown : unknowns) {
    problem->AddResidualBlock(WhitenedLinearTerm::Create(), nullptr, unknown);
  }
  problem->AddResidualBlock(
      new VolumeTerm(&model, &constraint, &whitening), nullptr, unknowns);
}

}  // namespace musclewarp
