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
// with the weights of the rows included, and optional one-sided rows.
struct MuscleTarget {
  Points laplacian;   // N x 3, mm: delta, pre-rotated
  Points skeleton;    // m x 3, mm times the weight: s'
  Points attachment;  // k x 3, mm times the weights: b'
  Points bending;     // r x 3, mm times the weights: d'

  // Rows beside those of the linear energy; TargetOf leaves them empty.
  OneSidedRows one_sided;
};

struct PreRotationOptions {
  // If true, the rotation of a Laplacian row includes the twist of the bodies
  // at the ends of its segment, where these are known, beside the smallest
  // rotation between the two directions of the segment. Without the twist a
  // muscle does not turn about its own line.
  bool use_body_twist = true;
};

// Computes the target of a muscle for a pose. Each Laplacian row is turned by
// the model's field of rotations (rotation_field.h), skeleton samples move
// with the guides of the lines (paper eq. 2.4 and 2.5) and attachment points
// with their bodies; fibres are to keep the curvature that they have at rest
// (bending_rows.h). At the rest pose the target equals J_f X_0, and a rigid
// motion of all bodies yields the target of the rigidly moved muscle. Bodies
// that the pose does not name stay where they are. If bones push the muscle
// aside (ScenePose::pushes), the minimiser of its linear energy is moved by the
// push.
MuscleTarget TargetOf(const MuscleModel& model,
                      const ScenePose& pose,
                      const PreRotationOptions& options);

// Adds J_f times displacements of the coarse vertices (N x 3, mm) to a target,
// so that they move the minimiser of the linear energy.
void AddRowsOf(const MuscleModel& model,
               const Points& displacements,
               MuscleTarget* target);

// The three functions below evaluate the linear energy and leave the one-sided
// rows out. `coarse` is X, N x 3, mm.

// Returns -J_f^T f(X), N x 3: the direction of steepest descent.
Points LinearDescent(const MuscleModel& model,
                     const MuscleTarget& target,
                     const Points& coarse);

// Returns 1/2 |f(X)|^2, mm^2 (paper eq. 2.8).
double LinearEnergy(const MuscleModel& model,
                    const MuscleTarget& target,
                    const Points& coarse);

// Returns the minimiser X* of the linear energy, N x 3, mm, without regard to
// the volume. It is computed as a displacement of the rest pose, so that a
// target equal to the rest pose yields the rest pose up to rounding.
Points UnconstrainedMinimizer(const MuscleModel& model,
                              const MuscleTarget& target);

}  // namespace musclewarp
