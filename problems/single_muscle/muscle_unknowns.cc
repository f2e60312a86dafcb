// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "problems/single_muscle/muscle_unknowns.h"

namespace musclewarp {

MuscleUnknowns::MuscleUnknowns(const MuscleModel& model,
                               const MuscleTarget& target,
                               MuscleFormulation formulation,
                               const Points& coarse) {
  if (formulation == MuscleFormulation::kWhitened) {
    whitening_.emplace(model, target);
  }
  SetCoarse(coarse);
}

const Points& MuscleUnknowns::CoarseOf(const Points& values) const {
  if (!whitening_) return last_coarse_ = values;
  if (last_values_.rows() != values.rows() || last_values_ != values) {
    last_values_ = values;
    last_coarse_ = whitening_->CoarseFromWhitened(values);
  }
  return last_coarse_;
}

const Points& MuscleUnknowns::CoarseOf(double const* const* blocks) const {
  Points values(num_blocks(), 3);
  for (int j = 0; j < num_blocks(); ++j) {
    values.row(j) = Eigen::Map<const Eigen::RowVector3d>(blocks[j]);
  }
  return CoarseOf(values);
}

Points MuscleUnknowns::GradientOf(const Points& coarse_gradient) const {
  return whitening_ ? whitening_->WhitenedGradient(coarse_gradient)
                    : coarse_gradient;
}

RowMajorMatrix MuscleUnknowns::RowsOf(const RowMajorMatrix& coarse_rows) const {
  return whitening_ ? whitening_->WhitenedRows(coarse_rows) : coarse_rows;
}

void MuscleUnknowns::SetCoarse(const Points& coarse) {
  values_ = whitening_ ? whitening_->WhitenedFromCoarse(coarse) : coarse;
}

std::vector<double*> MuscleUnknowns::Blocks() {
  std::vector<double*> blocks(values_.rows());
  for (size_t i = 0; i < blocks.size(); ++i) {
    blocks[i] = values_.data() + 3 * i;
  }
  return blocks;
}

}  // namespace musclewarp
