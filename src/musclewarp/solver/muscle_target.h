// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/scene/scene.h"
#include "musclewarp/skeleton/action_line.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/one_sided_rows.h"

namespace musclewarp {

// What a pose asks of one muscle: the right-hand side of f(X) in MuscleModel,
// and one-sided rows beside it.
struct MuscleTarget {
  Points laplacian;        // N x 3: delta, pre-rotated
  Points skeleton;         // m x 3: s', times the weight
  Points attachment;       // k x 3: b', times the weights
  OneSidedRows one_sided;  // rows beside those of the linear energy
};

struct PreRotationOptions {
  // Add the twist of the bodies at the ends of a segment, where they are known,
  // to the smallest rotation between the directions of the segment. Without it
  // a muscle does not turn about its own line.
  bool use_body_twist = true;
};

MuscleTarget TargetOf(const MuscleModel& model,
                      const ScenePose& pose,
                      const PreRotationOptions& options);

// -J_f^T f(X), N x 3: the steepest descent of the linear energy.
Points LinearDescent(const MuscleModel& model,
                     const MuscleTarget& target,
                     const Points& coarse);

// 1/2 |f(X)|^2, mm^2. One-sided rows are left out, here and below.
double LinearEnergy(const MuscleModel& model,
                    const MuscleTarget& target,
                    const Points& coarse);

// The minimiser X* of the linear energy. Computed as a displacement of the rest
// pose: a target equal to rest gives the rest pose back to rounding.
Points UnconstrainedMinimizer(const MuscleModel& model,
                              const MuscleTarget& target);

}  // namespace musclewarp
