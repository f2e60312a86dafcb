// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"
#include "problems/single_muscle/whitening.h"

namespace musclewarp {

enum class MuscleFormulation {
  kWhitened,  // fast: the linear rows are the identity
  kBlocks,    // a block per vertex, a term per row
};

// The parameter blocks of one muscle, each of size 3: the rows of X, or of the
// whitened Y.
class MuscleUnknowns {
 public:
  // Keeps a reference to `model`. `coarse` (N x 3) is the start.
  MuscleUnknowns(const MuscleModel& model,
                 const MuscleTarget& target,
                 MuscleFormulation formulation,
                 const Points& coarse);
  MuscleUnknowns(const MuscleUnknowns&) = delete;
  MuscleUnknowns& operator=(const MuscleUnknowns&) = delete;

  // N x 3, mm.
  const Points& Coarse() const { return CoarseOf(values_); }
  void SetCoarse(const Points& coarse);

  // X of other values of the blocks. The last is kept, as Ceres asks for the
  // same place more than once; valid until the next call. Not for use from
  // several threads.
  const Points& CoarseOf(const Points& values) const;
  // Of parameter blocks.
  const Points& CoarseOf(double const* const* blocks) const;

  // dg/d(values) of a function with the gradient dg/dX.
  Points GradientOf(const Points& coarse_gradient) const;
  // Rows that give points from values, of those that give them from X (k x N).
  RowMajorMatrix RowsOf(const RowMajorMatrix& coarse_rows) const;

  bool IsWhitened() const { return whitening_.has_value(); }
  double* data() { return values_.data(); }
  int size() const { return static_cast<int>(values_.size()); }
  int num_blocks() const { return static_cast<int>(values_.rows()); }
  std::vector<double*> Blocks();

 private:
  std::optional<Whitening> whitening_;
  Points values_;
  mutable Points last_values_;
  mutable Points last_coarse_;
};

}  // namespace musclewarp
