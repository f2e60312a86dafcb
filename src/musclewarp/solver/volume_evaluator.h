// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"

namespace musclewarp {

// The mesh whose volume is kept: that of the coarse mesh, scaled to the fine
// one, costs next to nothing and is what the paper uses far from the solution.
enum class VolumeMesh { kCoarse, kFine };

// The volume constraint of volume_constraint.h for solvers that ask for the
// same place more than once: Ceres does, first for the residual, then for the
// Jacobian. What is known of the last place is kept, so that each of the two
// costs one pass over W. Not for use from several threads.
class VolumeEvaluator {
 public:
  // Keeps both; `corrections` may be null.
  VolumeEvaluator(const MuscleModel& model,
                  const VertexCorrections* corrections);

  const MuscleModel& model() const { return model_; }

  // The fine one, to begin with.
  void SetMesh(VolumeMesh mesh);

  // g(X), mm^3.
  double Error(const Points& coarse);

  // J_g^T, N x 3, mm^2.
  const Points& Gradient(const Points& coarse);

  // To be called when `corrections` has changed.
  void Forget() { coarse_.resize(0, 3); }

 private:
  const MuscleModel& model_;
  const VertexCorrections* corrections_;
  VolumeMesh mesh_ = VolumeMesh::kFine;
  Points coarse_;  // the last place; no rows: none
  Points moved_;  // the same with held vertices, of the mesh whose volume it is
  double error_ = 0;
  Points gradient_;  // no rows: not asked for
};

}  // namespace musclewarp
