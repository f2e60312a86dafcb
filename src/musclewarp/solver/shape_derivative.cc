// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/shape_derivative.h"

#include <glog/logging.h>

#include <cmath>
#include <utility>

#include "musclewarp/geometry/dense_product.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/solver/one_sided_rows.h"

namespace musclewarp {
namespace {

// Conjugate gradients end where the energy norm of the error has fallen to this
// share of the solution, or to this length (mm): what is left in a moment arm
// is about a thousandth of the accuracy that is promised for it, 1e-3 mm.
constexpr double kTolerance = 1e-7;
constexpr double kSmallest = 1e-8;  // mm by rad or m
constexpr int kMaxIterations = 200;

double Dot(const Points& a, const Points& b) {
  return a.cwiseProduct(b).sum();
}

// Everything about a shape that does not depend on the coordinate.
class ShapeSystem {
 public:
  ShapeSystem(const MuscleModel& model,
              const MuscleTarget& target,
              const Points& coarse)
      : model_(model),
        rows_(target.one_sided),
        coarse_(coarse),
        fine_(Product(model.fine_from_coarse, coarse)),
        fine_from_coarse_(FineFromCoarse(model, rows_)),
        depths_(OneSidedDepths(rows_, fine_from_coarse_, coarse)),
        one_sided_(model, rows_),
        gradient_(
            TransposedProduct(model.fine_from_coarse,
                              VolumeGradient(fine_, model.fine_triangles))) {
    one_sided_.UpdateActiveRows(coarse);
    inverse_gradient_ = SolveA(gradient_);
    gradient_norm_ = Dot(gradient_, inverse_gradient_);
    // At a minimum the descent of the energy is lambda times the gradient.
    multiplier_ = Dot(inverse_gradient_, Descent(target)) / gradient_norm_;
  }

  ShapeRate Differentiate(const TargetRate& rate) const {
    ShapeRate result;
    Points residual = RightHandSide(rate);
    Points& solution = result.coarse;
    solution = Points::Zero(coarse_.rows(), 3);
    Points direction = solution, a_direction = solution;
    double norm_before = 0, first_norm = 0;
    for (; result.iterations < kMaxIterations; ++result.iterations) {
      double share = 0;
      const Points step = Projected(residual, &share);
      const double norm = Dot(residual, step);
      if (result.iterations == 0) first_norm = norm;
      if (!(std::sqrt(std::max(norm, 0.0)) >
            kSmallest + kTolerance * std::sqrt(first_norm))) {
        result.is_converged = std::isfinite(norm);
        return result;
      }
      const double beta = norm_before > 0 ? norm / norm_before : 0;
      direction = step + beta * direction;
      // A' times the step is known: it is what the step was solved for.
      a_direction = residual - share * gradient_ + beta * a_direction;
      const Points product = a_direction + multiplier_ * Hessian(direction);
      const double curvature = Dot(direction, product);
      if (!(curvature > 0)) return result;  // X is no minimum
      solution += norm / curvature * direction;
      residual -= norm / curvature * product;
      norm_before = norm;
    }
    return result;
  }

 private:
  // A'^-1 b.
  Points SolveA(const Points& b) const {
    return one_sided_.CorrectedSolution(model_.normal_matrix.solve(b));
  }

  // Returns A'^-1 (b - share * g) with the share for which the volume does not
  // change.
  Points Projected(const Points& b, double* share) const {
    const Points solution = SolveA(b);
    *share = Dot(gradient_, solution) / gradient_norm_;
    return solution - *share * inverse_gradient_;
  }

  // H times a direction. The gradient is quadratic in X, so that the difference
  // of two of them is exact.
  Points Hessian(const Points& direction) const {
    const Points fine = Product(model_.fine_from_coarse, direction);
    return TransposedProduct(
        model_.fine_from_coarse,
        (VolumeGradient(fine_ + fine, model_.fine_triangles) -
         VolumeGradient(fine_ - fine, model_.fine_triangles)) /
            2);
  }

  // Adds the forces (K x 3) on the vertices of active rows, by weight^2.
  void AddForces(const Points& forces, Points* sum) const {
    if (rows_.size() == 0) return;
    *sum += rows_.weight * rows_.weight * fine_from_coarse_.transpose() *
            forces;
  }

  // The direction of steepest descent of the energy without the constraint.
  Points Descent(const MuscleTarget& target) const {
    Points descent = LinearDescent(model_, target, coarse_);
    AddForces(depths_.cwiseMax(0).asDiagonal() * rows_.normals, &descent);
    return descent;
  }

  // J_f^T dr/dq, and how the forces of the active rows change with their planes
  // while the shape stands still.
  Points RightHandSide(const TargetRate& rate) const {
    Points sum = LinearDescent(
        model_, rate.linear, Points::Zero(coarse_.rows(), 3));
    Points forces = Points::Zero(rows_.size(), 3);
    for (int k = 0; k < rows_.size(); ++k) {
      if (depths_[k] <= 0) continue;
      forces.row(k) = rate.plane_speeds[k] * rows_.normals.row(k) +
                      depths_[k] * rate.plane_turns.row(k);
    }
    AddForces(forces, &sum);
    return sum;
  }

  const MuscleModel& model_;
  const OneSidedRows& rows_;
  const Points& coarse_;
  const Points fine_;                      // n x 3: W X
  const RowMajorMatrix fine_from_coarse_;  // K x N, of the rows
  const Eigen::VectorXd depths_;           // K
  OneSidedSystem one_sided_;
  const Points gradient_;    // g
  Points inverse_gradient_;  // A'^-1 g
  double gradient_norm_ = 0;  // g^T A'^-1 g
  double multiplier_ = 0;     // lambda
};

}  // namespace

std::vector<ShapeRate> DifferentiateShape(
    const MuscleModel& model,
    const MuscleTarget& target,
    const Points& coarse,
    const std::vector<TargetRate>& rates) {
  CHECK_EQ(coarse.rows(), model.coarse_rest.rows());
  std::vector<ShapeRate> results;
  if (rates.empty()) return results;
  const ShapeSystem system(model, target, coarse);
  for (const TargetRate& rate : rates) {
    CHECK_EQ(rate.plane_speeds.size(), target.one_sided.size());
    CHECK_EQ(rate.plane_turns.rows(), target.one_sided.size());
    results.push_back(system.Differentiate(rate));
  }
  return results;
}

}  // namespace musclewarp
