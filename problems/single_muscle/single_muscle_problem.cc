// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/single_muscle_problem.h"

#include <vector>

#include "problems/single_muscle/coordinates_term.h"
#include "problems/single_muscle/laplacian_term.h"
#include "problems/single_muscle/one_sided_term.h"
#include "problems/single_muscle/volume_term.h"
#include "problems/single_muscle/whitened_linear_term.h"

namespace musclewarp {
namespace {

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

void AddMuscle(const MuscleModel& model,
               const MuscleTarget& target,
               const HardConstraint& constraint,
               VolumeEvaluator* volume,
               MuscleUnknowns* unknowns,
               ceres::Problem* problem) {
  const std::vector<double*> blocks = unknowns->Blocks();
  if (unknowns->IsWhitened()) {
    for (double* block : blocks) {
      problem->AddResidualBlock(WhitenedLinearTerm::Create(), nullptr, block);
    }
  } else {
    AddLaplacianTerms(model, target, blocks, problem);
    AddCoordinatesTerms(model.skeleton, target.skeleton, blocks, problem);
    AddCoordinatesTerms(model.attachment, target.attachment, blocks, problem);
    AddCoordinatesTerms(
        model.bending.from_coarse, target.bending, blocks, problem);
  }
  if (target.one_sided.size() > 0) {
    problem->AddResidualBlock(
        new OneSidedTerm(model, &target.one_sided, unknowns), nullptr, blocks);
  }
  problem->AddResidualBlock(
      new VolumeTerm(unknowns, volume, &constraint), nullptr, blocks);
}

}  // namespace musclewarp
