// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"

namespace musclewarp {

// How what a pose asks of a muscle changes with a coordinate q of the skeleton,
// by rad or m. K is the number of one-sided rows of the target.
struct TargetRate {
  // The derivatives of the fields of MuscleTarget, with the weights of the
  // rows: dr/dq. Its one-sided rows are not used.
  MuscleTarget linear;

  // The velocity of each plane along its normal, n . dc/dq, K, mm, where c is
  // the foot of the row's vertex on the plane, and the derivative of its normal
  // dn/dq, K x 3.
  Eigen::VectorXd plane_speeds;
  Points plane_turns;
};

// The derivative of the shape of a muscle, by rad or m.
struct ShapeRate {
  Points coarse;       // N x 3, mm: dX/dq
  Points fine;         // n x 3, mm: W dX/dq
  int iterations = 0;  // of conjugate gradients
  bool is_converged = false;
};

// Differentiates the converged shape X of a muscle implicitly with respect to
// coordinates, of which each has a rate. X minimises the energy of the target,
// one-sided rows included, subject to V(W X) = V_hat, whatever solver found it.
// One-sided rows that are active at X stay so and no others become active. Each
// rate is the solution of the KKT system
//
//   [ A' + lambda H   g ] [ dX/dq      ]   [ J_f^T dr/dq + d(rows)/dq ]
//   [ g^T             0 ] [ dlambda/dq ] = [ 0                        ]
//
// where A' = J_f^T J_f with the active rows, g and H are the gradient and the
// Hessian of the volume, and lambda is the multiplier of the constraint. H is
// exact but never formed. The system is solved by conjugate gradients in the
// shapes of constant volume, preconditioned by A' (Gould, Hribar and Nocedal
// 2001), which take a few iterations as lambda H is small beside A'
// (docs/method.md).
//
// `coarse` is X (N x 3, mm) and `fine` is W X (n x 3, mm). Where X is not a
// minimum, the shape is taken to keep its displacement from one. Where neither
// the target nor a plane moves, the rate is exactly zero, and costs nothing.
std::vector<ShapeRate> DifferentiateShape(const MuscleModel& model,
                                          const MuscleTarget& target,
                                          const Points& coarse,
                                          const Points& fine,
                                          const std::vector<TargetRate>& rates);

}  // namespace musclewarp
