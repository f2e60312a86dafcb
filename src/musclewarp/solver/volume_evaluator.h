// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_state.h"

namespace musclewarp {

// The mesh whose volume is constrained. The volume of the coarse mesh, scaled
// by the ratio of the rest volumes, costs next to nothing and is what the paper
// uses far from the solution; the fine mesh is what counts in the end.
enum class VolumeMesh { kCoarse, kFine };

// The volume constraint of volume_constraint.h for solvers that evaluate it
// more than once at the same place. Ceres does so: it asks for the residual
// first and for the Jacobian later. The evaluator remembers the last place, so
// that error and gradient cost one pass over the dense matrix W each. Not to be
// used from several threads at once.
class VolumeEvaluator {
 public:
  // Keeps both arguments; `corrections` may be null if there are none.
  VolumeEvaluator(const MuscleModel& model,
                  const VertexCorrections* corrections);

  const MuscleModel& model() const { return model_; }

  // Selects the mesh whose volume is constrained; at first the fine one.
  void SetMesh(VolumeMesh mesh);

  // Lets Gradient() return that of another place if no coarse vertex moves by
  // more than `distance`, mm, between the two; at first 0. The gradient turns
  // by the move over the thickness of the muscle, so that a solver that is
  // close to the solution loses nothing.
  void ReuseGradientWithin(double distance) { reuse_within_ = distance; }

  // Returns the volume error g(X), mm^3, at `coarse` (N x 3, mm).
  double Error(const Points& coarse);

  // Returns J_g^T, N x 3, mm^2: the gradient of what Error returns, for either
  // mesh. The reference is valid until the next call.
  const Points& Gradient(const Points& coarse);

  // Discards what is remembered. To be called when `corrections` has changed.
  void Forget() {
    coarse_.resize(0, 3);
    gradient_.resize(0, 3);
  }

 private:
  const MuscleModel& model_;
  const VertexCorrections* corrections_;
  VolumeMesh mesh_ = VolumeMesh::kFine;
  Points coarse_;  // the last place; no rows if there is none
  Points moved_;  // the vertices of the selected mesh there, held ones included
  double error_ = 0;
  double reuse_within_ = 0;           // mm
  Points gradient_, gradient_place_;  // no rows if nobody has asked for it
};

}  // namespace musclewarp
