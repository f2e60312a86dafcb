// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ceres/evaluation_callback.h>

#include <memory>
#include <vector>

#include "musclewarp/solver/volume_evaluator.h"
#include "problems/single_muscle/muscle_unknowns.h"

namespace musclewarp {

// Evaluates the volumes of all muscles, nearly all the work of an evaluation,
// before Ceres asks for them: a muscle a thread. Ceres' own threads would add
// up the cost in an order that depends on their number.
class VolumePrefetch : public ceres::EvaluationCallback {
 public:
  // Keeps both, one entry a muscle.
  VolumePrefetch(const std::vector<std::unique_ptr<MuscleUnknowns>>& unknowns,
                 const std::vector<std::unique_ptr<VolumeEvaluator>>& volumes)
      : unknowns_(unknowns), volumes_(volumes) {}

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
