// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/solver/shape_derivative.h"

#include <glog/logging.h>

#include <cmath>
#include <utility>

#include "musclewarp/geometry/fine_map.h"
#include "musclewarp/geometry/thin_product.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/solver/one_sided_rows.h"

namespace musclewarp {
namespace {

// Conjugate gradients end where the residual, in the norm of A'^-1, has fallen
// to this share of the right-hand side, or to this length. What is left in
// moment arms of the LHDL hip is 8e-4 mm, of 50.
constexpr double kTolerance = 1e-5;
constexpr double kSmallest = 1e-8;  // mm by rad or m
constexpr int kMaxIterations = 200;

double Dot(const Points& a, const Points& b) { return a.cwiseProduct(b).sum(); }

// Whether a target stands still that changes by `rate`.
bool IsZero(const MuscleTarget& rate) {
  return rate.laplacian.isZero(0) && rate.skeleton.isZero(0) &&
         rate.attachment.isZero(0) && rate.bending.isZero(0);
}

// Everything about a shape that does not depend on the coordinate.
class ShapeSystem {
 public:
  ShapeSystem(const MuscleModel& model,
              const MuscleTarget& target,
              const Points& coarse,
              const Points& fine)
      : model_(model),
        rows_(target.one_sided),
        coarse_(coarse),
        fine_(fine),
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

  // Differentiates with respect to all coordinates side by side, so that the
  // large matrix W is read once for all of them in each iteration.
  std::vector<ShapeRate> Differentiate(
      const std::vector<TargetRate>& rates) const {
    std::vector<ConjugateGradients> solves(rates.size());
    for (size_t i = 0; i < rates.size(); ++i) {
      solves[i].residual = RightHandSide(rates[i]);
      solves[i].rate.coarse = Points::Zero(coarse_.rows(), 3);
      solves[i].rate.fine = Points::Zero(fine_.rows(), 3);
      if (!solves[i].residual.isZero(0)) continue;
      solves[i].is_done = true;
      solves[i].rate.is_converged = true;
    }
    for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
      std::vector<ConjugateGradients*> open;
      std::vector<Points> directions;
      for (ConjugateGradients& solve : solves) {
        if (solve.is_done) continue;
        ChooseDirection(&solve);
        if (solve.is_done) continue;
        open.push_back(&solve);
        directions.push_back(solve.direction);
      }
      if (open.empty()) break;
      const std::vector<Points> fine =
          Products(model_.fine_from_coarse, directions);
      const std::vector<Points> bent = Hessians(fine);
      for (size_t k = 0; k < open.size(); ++k) Step(fine[k], bent[k], open[k]);
    }
    std::vector<ShapeRate> results;
    for (ConjugateGradients& solve : solves) {
      results.push_back(std::move(solve.rate));
    }
    return results;
  }

 private:
  // The solve for one coordinate.
  struct ConjugateGradients {
    ShapeRate rate;
    Points residual;
    Points direction, a_direction;     // the latter is A' times the former
    double norm = 0, first_norm = -1;  // of the residual, squared
    bool is_done = false;
  };

  void ChooseDirection(ConjugateGradients* solve) const {
    double share = 0;
    const Points step = Projected(solve->residual, &share);
    const double norm_before = solve->norm;
    solve->norm = Dot(solve->residual, step);
    const bool is_first = solve->first_norm < 0;
    if (is_first) solve->first_norm = solve->norm;
    if (!(std::sqrt(std::max(solve->norm, 0.0)) >
          kSmallest + kTolerance * std::sqrt(solve->first_norm))) {
      solve->is_done = true;
      solve->rate.is_converged = std::isfinite(solve->norm);
      return;
    }
    // A' times the step is known: it is what the step was solved for.
    const Points a_step = solve->residual - share * gradient_;
    if (is_first) {
      solve->direction = step;
      solve->a_direction = a_step;
      return;
    }
    const double beta = solve->norm / norm_before;
    solve->direction = step + beta * solve->direction;
    solve->a_direction = a_step + beta * solve->a_direction;
  }

  // Goes along the direction; `fine` is W times it, `bent` is H times it.
  void Step(const Points& fine,
            const Points& bent,
            ConjugateGradients* solve) const {
    const Points product = solve->a_direction + multiplier_ * bent;
    const double curvature = Dot(solve->direction, product);
    if (!(curvature > 0)) {  // X is no minimum
      solve->is_done = true;
      return;
    }
    const double length = solve->norm / curvature;
    solve->rate.coarse += length * solve->direction;
    solve->rate.fine += length * fine;
    solve->residual -= length * product;
    ++solve->rate.iterations;
  }

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

  // H times directions, which `fine` has as directions of the fine vertices.
  std::vector<Points> Hessians(const std::vector<Points>& fine) const {
    std::vector<Points> bent;
    for (const Points& direction : fine) {
      bent.push_back(
          VolumeGradientRate(fine_, direction, model_.fine_triangles));
    }
    return TransposedProducts(model_.fine_from_coarse, bent);
  }

  // The direction of steepest descent of the energy without the constraint.
  Points Descent(const MuscleTarget& target) const {
    return LinearDescent(model_, target, coarse_) +
           OneSidedDescent(
               rows_, one_sided_.fine_from_coarse(), one_sided_.depths());
  }

  // J_f^T dr/dq, and how the forces of the active rows change with their planes
  // while the shape stands still.
  Points RightHandSide(const TargetRate& rate) const {
    Points sum = Points::Zero(coarse_.rows(), 3);
    if (!IsZero(rate.linear)) sum = LinearDescent(model_, rate.linear, sum);
    const Eigen::VectorXd& depths = one_sided_.depths();
    Points forces = Points::Zero(rows_.size(), 3);
    for (int k = 0; k < rows_.size(); ++k) {
      if (depths[k] <= 0) continue;
      forces.row(k) = rate.plane_speeds[k] * rows_.normals.row(k) +
                      depths[k] * rate.plane_turns.row(k);
    }
    return sum +
           rows_.weight * rows_.weight *
               ThinTransposedProduct(one_sided_.fine_from_coarse(), forces);
  }

  const MuscleModel& model_;
  const OneSidedRows& rows_;
  const Points& coarse_;
  const Points& fine_;  // n x 3: W X
  OneSidedSystem one_sided_;
  const Points gradient_;     // g
  Points inverse_gradient_;   // A'^-1 g
  double gradient_norm_ = 0;  // g^T A'^-1 g
  double multiplier_ = 0;     // lambda
};

}  // namespace

std::vector<ShapeRate> DifferentiateShape(
    const MuscleModel& model,
    const MuscleTarget& target,
    const Points& coarse,
    const Points& fine,
    const std::vector<TargetRate>& rates) {
  CHECK_EQ(coarse.rows(), model.coarse_rest.rows());
  CHECK_EQ(fine.rows(), model.fine_rest.rows());
  for (const TargetRate& rate : rates) {
    CHECK_EQ(rate.plane_speeds.size(), target.one_sided.size());
    CHECK_EQ(rate.plane_turns.rows(), target.one_sided.size());
  }
  if (rates.empty()) return {};
  return ShapeSystem(model, target, coarse, fine).Differentiate(rates);
}

}  // namespace musclewarp
