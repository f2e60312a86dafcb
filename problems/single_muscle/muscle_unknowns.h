// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"
#include "problems/single_muscle/whitening.h"

namespace musclewarp {

// The unknowns in which Ceres solves for a muscle.
enum class MuscleFormulation {
  kWhitened,  // whitened unknowns: fast, the linear rows are the identity
  kBlocks,    // coarse vertices: readable, a residual block per row
};

// The parameter blocks of one muscle, each of size 3: the rows of X, or in the
// whitened formulation those of Y (Whitening). Terms and drivers work on X and
// leave the choice of unknowns to this class.
//
// Not to be used from several threads at once, because the last conversion to X
// is remembered.
class MuscleUnknowns {
 public:
  // Starts at the coarse vertices `coarse` (N x 3, mm). Keeps a reference to
  // `model`. Ceres holds pointers into this object, so it cannot be copied.
  MuscleUnknowns(const MuscleModel& model,
                 const MuscleTarget& target,
                 MuscleFormulation formulation,
                 const Points& coarse);
  MuscleUnknowns(const MuscleUnknowns&) = delete;
  MuscleUnknowns& operator=(const MuscleUnknowns&) = delete;

  // X of the parameter blocks, N x 3, mm. The reference is valid until the next
  // call of Coarse or CoarseOf.
  const Points& Coarse() const { return CoarseOf(values_); }
  void SetCoarse(const Points& coarse);

  // X of other values of the blocks, N x 3. The second one takes a pointer per
  // block, as Ceres passes them to a cost function. Ceres asks for one place
  // more than once; only the first time costs a triangular solve.
  const Points& CoarseOf(const Points& values) const;
  const Points& CoarseOf(double const* const* blocks) const;

  // Returns the gradient with respect to the values of the blocks of a function
  // whose gradient with respect to X is given, both N x 3.
  Points GradientOf(const Points& coarse_gradient) const;

  // Returns the derivative of points p = R X with respect to the values of the
  // blocks, for rows R; both k x N, the same for x, y and z.
  RowMajorMatrix RowsOf(const RowMajorMatrix& coarse_rows) const;

  bool IsWhitened() const { return whitening_.has_value(); }

  // The values of all blocks, one after the other, and their number.
  double* data() { return values_.data(); }
  int size() const { return static_cast<int>(values_.size()); }

  // The N blocks, in the order of the coarse vertices.
  int num_blocks() const { return static_cast<int>(values_.rows()); }
  std::vector<double*> Blocks();

 private:
  std::optional<Whitening> whitening_;
  Points values_;
  mutable Points last_values_;  // with last_coarse_ their X
  mutable Points last_coarse_;
};

}  // namespace musclewarp
