// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/path_functions/path_fit.h"

#include <glog/logging.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/option_check.h"
#include "musclewarp/path_functions/legendre_terms.h"

namespace musclewarp {
namespace {

// A term is not chosen if samples determine less than this share of it, given
// those that are chosen.
constexpr double kUndetermined = 1e-8;

// The search ends when so many more terms have not improved the prediction.
constexpr int kPatience = 12;

// The equations of least squares of some samples: the sum of (rows * x -
// right)^2 is x' * matrix * x - 2 * x' * right + square.
struct NormalEquations {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
  double square = 0;
  int rows = 0;
  Eigen::VectorXd penalty;  // for the square of each coefficient, mm^-2

  NormalEquations& operator+=(const NormalEquations& other) {
    matrix += other.matrix;
    right += other.right;
    square += other.square;
    rows += other.rows;
    penalty += other.penalty;
    return *this;
  }
};

// Terms and their coefficients.
struct Choice {
  std::vector<int> terms;
  Eigen::VectorXd coefficients;
};

Eigen::MatrixXd Part(const Eigen::MatrixXd& matrix,
                     const std::vector<int>& terms) {
  return matrix(terms, terms);
}

// Factors the equations of some terms, with what their coefficients cost and a
// little more than zero on the diagonal: a group may determine less than all
// samples do.
Eigen::LLT<Eigen::MatrixXd> Factor(const NormalEquations& equations,
                                   const std::vector<int>& terms) {
  constexpr double kShare = 1e-10;
  Eigen::MatrixXd matrix = Part(equations.matrix, terms);
  matrix.diagonal() *= 1 + kShare;
  matrix.diagonal() += equations.penalty(terms);
  matrix.diagonal().array() += kShare;
  return matrix.llt();
}

Eigen::VectorXd Solve(const NormalEquations& equations,
                      const std::vector<int>& terms) {
  return Factor(equations, terms).solve(equations.right(terms));
}

// The sum of squares of errors at the samples of the equations.
double Misfit(const NormalEquations& equations, const Choice& choice) {
  const Eigen::VectorXd& x = choice.coefficients;
  return x.dot(Part(equations.matrix, choice.terms) * x) -
         2 * x.dot(equations.right(choice.terms)) + equations.square;
}

// Returns a term and the terms below it that are not chosen, those below first.
std::vector<int> WithTermsBelow(int term,
                                const std::vector<std::vector<int>>& below,
                                std::vector<char>* is_chosen) {
  std::vector<int> terms;
  if ((*is_chosen)[term]) return terms;
  (*is_chosen)[term] = 1;
  for (const int other : below[term]) {
    const std::vector<int> more = WithTermsBelow(other, below, is_chosen);
    terms.insert(terms.end(), more.begin(), more.end());
  }
  terms.push_back(term);
  return terms;
}

// Returns the term that explains most of what the chosen ones leave, with the
// terms below it that it needs: the most by each term that comes with it.
// Returns nothing if the samples determine no more. A term alone that needs
// others is looked at too, as none of these may explain anything by itself.
std::vector<int> BestAddition(const NormalEquations& equations,
                              const std::vector<int>& chosen,
                              const std::vector<std::vector<int>>& below) {
  std::vector<char> is_chosen(below.size(), 0);
  for (const int term : chosen) is_chosen[term] = 1;
  std::vector<int> candidates;
  for (size_t i = 0; i < below.size(); ++i) {
    if (!is_chosen[i]) candidates.push_back(static_cast<int>(i));
  }
  const auto factor = Factor(equations, chosen);
  const Eigen::MatrixXd across = equations.matrix(chosen, candidates);
  const Eigen::MatrixXd solved = factor.solve(across);
  const Eigen::VectorXd rest = equations.right(chosen);
  std::vector<int> best;
  double most = 0;
  for (size_t i = 0; i < candidates.size(); ++i) {
    const int term = candidates[i];
    const double whole = equations.matrix(term, term) + equations.penalty[term];
    const double free = whole - solved.col(i).dot(across.col(i));
    if (!(free > kUndetermined * (whole + 1))) continue;
    const double explains =
        std::pow(equations.right[term] - solved.col(i).dot(rest), 2) / free;
    if (!(explains > most)) continue;
    std::vector<char> taken = is_chosen;
    std::vector<int> terms = WithTermsBelow(term, below, &taken);
    const double by_term = explains / static_cast<double>(terms.size());
    if (!(by_term > most)) continue;
    most = by_term;
    best = std::move(terms);
  }
  return best;
}

// The sum over all groups of the squares of errors at samples of a group, with
// terms fitted to the other groups.
double PredictionMisfit(const std::vector<NormalEquations>& groups,
                        const std::vector<NormalEquations>& others,
                        const std::vector<int>& terms) {
  double misfit = 0;
  for (size_t g = 0; g < groups.size(); ++g) {
    misfit += Misfit(groups[g], {terms, Solve(others[g], terms)});
  }
  return misfit;
}

// Chooses terms by cross-validation over groups, and fits them to all groups:
// of the sets on the way to the best one the smallest that is all but as good.
Choice ChooseTerms(const std::vector<NormalEquations>& groups,
                   const std::vector<std::vector<int>>& below) {
  constexpr double kAsGood = 1.01;
  constexpr double kNegligible = 0.02;  // of errors that count alike
  NormalEquations all = groups[0];
  for (size_t g = 1; g < groups.size(); ++g) all += groups[g];
  // A single group predicts itself.
  std::vector<NormalEquations> others(groups.size(), all);
  for (size_t g = 0; g < groups.size() && groups.size() > 1; ++g) {
    others[g].matrix -= groups[g].matrix;
    others[g].right -= groups[g].right;
    others[g].penalty -= groups[g].penalty;
  }
  std::vector<int> terms = {0};
  std::vector<std::pair<size_t, double>> misfits;  // by number of terms
  size_t best = 0;
  while (true) {
    misfits.emplace_back(terms.size(), PredictionMisfit(groups, others, terms));
    if (misfits.back().second < misfits[best].second) best = misfits.size() - 1;
    if (misfits.back().first > misfits[best].first + kPatience) break;
    const std::vector<int> next = BestAddition(all, terms, below);
    if (next.empty()) break;
    terms.insert(terms.end(), next.begin(), next.end());
  }
  const double enough = kAsGood * std::max(0.0, misfits[best].second) +
                        kNegligible * kNegligible * all.rows;
  const auto first =
      std::find_if(misfits.begin(), misfits.end(), [&](const auto& misfit) {
        return misfit.second <= enough;
      });
  terms.resize(first->first);
  return {terms, Solve(all, terms)};
}

// The samples of the coordinates that matter.
std::vector<PathSample> WithCoordinates(const std::vector<PathSample>& samples,
                                        const std::vector<int>& coordinates) {
  std::vector<PathSample> some;
  for (const PathSample& sample : samples) {
    some.push_back({sample.coordinates(coordinates),
                    sample.length,
                    sample.arms(coordinates),
                    sample.weight});
  }
  return some;
}

// What the coefficients of terms cost for each sample, more the higher their
// degree n is: n^6, as the square of a third derivative does. It keeps
// functions sane in corners of the range that have no samples. With this
// factor, held-back errors of the LHDL hip are on the mean what they are
// without, and their largest ones half of it; with ten times as much they grow.
Eigen::VectorXd PenaltyOf(const LegendreTerms& terms) {
  constexpr double kFactor = 1e-5;
  return kFactor *
         terms.degrees.cast<double>().rowwise().sum().array().pow(6).matrix();
}

NormalEquations EquationsOf(const LegendreTerms& terms,
                            const Eigen::VectorXd& penalty,
                            const PathSample& sample,
                            const PathFitOptions& options) {
  const Eigen::Index dimension = sample.arms.size();
  Eigen::MatrixXd rows(dimension + 1, terms.degrees.rows());
  Eigen::VectorXd right(dimension + 1);
  rows.row(0) = TermValues(terms, sample.coordinates) / options.length_error;
  right[0] = sample.length / options.length_error;
  for (Eigen::Index k = 0; k < dimension; ++k) {
    rows.row(k + 1) =
        TermValues(terms, sample.coordinates, static_cast<int>(k)) /
        -options.arm_error;
    right[k + 1] = sample.arms[k] / options.arm_error;
  }
  const double weight = sample.weight * sample.weight;
  return {weight * (rows.transpose() * rows),
          weight * (rows.transpose() * right),
          weight * right.squaredNorm(),
          static_cast<int>(rows.rows()),
          weight * penalty};
}

ErrorFigures FiguresOf(std::vector<std::pair<double, int>> errors) {
  ErrorFigures figures;
  if (errors.empty()) return figures;
  const auto count = static_cast<double>(errors.size());
  for (const auto& error : errors) {
    figures.mean += error.first / count;
    figures.rms += error.first * error.first / count;
  }
  figures.rms = std::sqrt(figures.rms);
  std::sort(errors.begin(), errors.end());
  constexpr double kShare = 0.95;
  const auto place = static_cast<size_t>(kShare * (count - 1) + 0.5);
  figures.quantile_95 = errors[place].first;
  figures.largest = errors.back().first;
  figures.worst_sample = errors.back().second;
  return figures;
}

// Collects errors of functions at samples.
class Errors {
 public:
  void Add(const PathFunction& path, const PathSample& sample, int number) {
    if (sample.weight < 1) return;
    // At its ends the range of a group may be wider than that of the others;
    // the polynomial itself is what is judged.
    PathFunction everywhere = path;
    everywhere.low.setConstant(sample.coordinates.size(), -kInfinity);
    everywhere.high.setConstant(sample.coordinates.size(), kInfinity);
    const PathValue value = Evaluate(everywhere, sample.coordinates);
    lengths_.emplace_back(std::abs(value.length - sample.length), number);
    for (Eigen::Index k = 0; k < value.arms.size(); ++k) {
      arms_.emplace_back(std::abs(value.arms[k] - sample.arms[k]), number);
    }
  }

  PathErrors Figures() const { return {FiguresOf(lengths_), FiguresOf(arms_)}; }

 private:
  std::vector<std::pair<double, int>> lengths_, arms_;
};

PathFunction FunctionOf(const LegendreTerms& terms, const Choice& choice) {
  PathFunction path;
  SetPolynomial(terms, choice.terms, choice.coefficients, &path);
  return path;
}

}  // namespace

bool PathFitOptions::IsValid(std::string* error) const {
  return OptionCheck("PathFitOptions", error)
      .IsAbove("length_error", length_error, 0)
      .IsAbove("arm_error", arm_error, 0)
      .IsAtLeast("groups", groups, 2)
      .is_valid();
}

PathFit FitPath(const std::vector<PathSample>& all_samples,
                const std::vector<int>& coordinates,
                const PathFitOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CHECK(!all_samples.empty());
  const std::vector<PathSample> samples =
      WithCoordinates(all_samples, coordinates);
  Eigen::VectorXd low = samples[0].coordinates, high = low;
  for (const PathSample& sample : samples) {
    low = low.cwiseMin(sample.coordinates);
    high = high.cwiseMax(sample.coordinates);
  }
  const LegendreTerms terms = AllTerms(low, high);
  const std::vector<std::vector<int>> below = TermsBelow(terms);
  const Eigen::VectorXd penalty = PenaltyOf(terms);
  const auto num_groups =
      std::min(samples.size(), static_cast<size_t>(options.groups));
  std::vector<NormalEquations> groups(num_groups);
  for (size_t i = 0; i < samples.size(); ++i) {
    NormalEquations equations =
        EquationsOf(terms, penalty, samples[i], options);
    if (i < num_groups) {
      groups[i] = std::move(equations);
    } else {
      groups[i % num_groups] += equations;
    }
  }
  PathFit fit;
  if (num_groups > 1) {
    Errors held_back;
    for (size_t g = 0; g < num_groups; ++g) {
      std::vector<NormalEquations> others = groups;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(g));
      const PathFunction path = FunctionOf(terms, ChooseTerms(others, below));
      for (size_t i = g; i < samples.size(); i += num_groups) {
        held_back.Add(path, samples[i], static_cast<int>(i));
      }
    }
    fit.held_back = held_back.Figures();
  }
  fit.path = FunctionOf(terms, ChooseTerms(groups, below));
  fit.path.coordinates = coordinates;
  fit.path.low = low;
  fit.path.high = high;
  Errors at_samples;
  for (size_t i = 0; i < samples.size(); ++i) {
    at_samples.Add(fit.path, samples[i], static_cast<int>(i));
  }
  fit.at_samples = at_samples.Figures();
  return fit;
}

}  // namespace musclewarp
