// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/evaluation_callback.h>

#include <memory>
#include <vector>

#include "musclewarp/solver/volume_evaluator.h"
#include "problems/single_muscle/muscle_unknowns.h"

namespace musclewarp {

// Evaluates the volumes of all muscles before Ceres asks for them, in parallel
// over the muscles. The volumes are nearly all the work of an evaluation, since
// each is a pass over a dense matrix; their terms then find the results in the
// VolumeEvaluators.
//
// The threads of Ceres itself (Solver::Options::num_threads) are not used,
// because they would sum the cost in an order that depends on their number.
class VolumePrefetch : public ceres::EvaluationCallback {
 public:
  // Keeps references to both, which have one entry per muscle and may be filled
  // later.
  VolumePrefetch(const std::vector<std::unique_ptr<MuscleUnknowns>>& unknowns,
                 const std::vector<std::unique_ptr<VolumeEvaluator>>& volumes)
      : unknowns_(unknowns), volumes_(volumes) {}

  // Called by Ceres, after it has written the point to the parameter blocks.
  void PrepareForEvaluation(bool evaluate_jacobians,
                            bool /*new_evaluation_point*/) override {
    const int count = static_cast<int>(volumes_.size());
#pragma omp parallel for schedule(dynamic)
    for (int i = 0; i < count; ++i) {
      const Points& coarse = unknowns_[i]->Coarse();
      volumes_[i]->Error(coarse);
      if (evaluate_jacobians) volumes_[i]->Gradient(coarse);
    }
  }

 private:
  const std::vector<std::unique_ptr<MuscleUnknowns>>& unknowns_;
  const std::vector<std::unique_ptr<VolumeEvaluator>>& volumes_;
};

}  // namespace musclewarp
