// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/path_functions/path_survey.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/base/infinity.h"
#include "musclewarp/base/random_draws.h"

namespace musclewarp {
namespace {

constexpr int kPieces = 100;
constexpr double kBeyond = 0.1;  // of the line, at both ends

// Two points at which a random line leaves the range.
struct Line {
  Eigen::VectorXd begin, end;
};

Line DrawLine(const Eigen::VectorXd& low,
              const Eigen::VectorXd& high,
              RandomDraws* draws) {
  const Eigen::Index dimension = low.size();
  Eigen::VectorXd through(dimension), direction(dimension);
  for (Eigen::Index k = 0; k < dimension; ++k) {
    through[k] = draws->Uniform(low[k], high[k]);
    direction[k] = draws->Uniform(-1, 1) * (high[k] - low[k]);
  }
  double backward = -kInfinity, forward = kInfinity;
  for (Eigen::Index k = 0; k < dimension; ++k) {
    if (direction[k] == 0) continue;
    const double a = (low[k] - through[k]) / direction[k];
    const double b = (high[k] - through[k]) / direction[k];
    backward = std::max(backward, std::min(a, b));
    forward = std::min(forward, std::max(a, b));
  }
  if (!std::isfinite(forward - backward)) return {through, through};
  return {through + backward * direction, through + forward * direction};
}

// The arms along a line.
class ArmsAlong {
 public:
  ArmsAlong(const ArmsAt& arms, const Line& line)
      : arms_(arms), line_(line), way_(line.end - line.begin) {}

  double length() const { return way_.norm(); }

  // `place`: from 0 to kPieces.
  Eigen::VectorXd operator()(double place) const {
    const double t = -kBeyond + (1 + 2 * kBeyond) * place / kPieces;
    return arms_(line_.begin + t * way_);
  }

 private:
  const ArmsAt& arms_;
  const Line& line_;
  const Eigen::VectorXd way_;
};

// Returns true if at least half of what an arm changes by in a piece, to and
// fro together, is in one sixteenth of it.
bool Jumps(const ArmsAlong& arms, int piece, Eigen::Index arm) {
  constexpr int kParts = 16;
  double largest = 0, sum = 0;
  double before = arms(piece)[arm];
  for (int i = 1; i <= kParts; ++i) {
    const double here = arms(piece + static_cast<double>(i) / kParts)[arm];
    const double change = std::abs(here - before);
    largest = std::max(largest, change);
    sum += change;
    before = here;
  }
  return sum >= kJump && largest >= sum / 2;
}

void FollowLine(const ArmsAlong& arms, PathSurvey* survey) {
  if (!(arms.length() > 0)) return;
  const double piece_length = (1 + 2 * kBeyond) * arms.length() / kPieces;
  Eigen::VectorXd before = arms(0);
  const Eigen::Index dimension = before.size();
  Eigen::VectorXd signs = Eigen::VectorXd::Zero(dimension);
  std::vector<int> changes(dimension, 0);
  for (int i = 0; i <= kPieces; ++i) {
    const Eigen::VectorXd here = arms(i);
    for (Eigen::Index k = 0; k < dimension; ++k) {
      const double change = std::abs(here[k] - before[k]);
      survey->steepest = std::max(survey->steepest, change / piece_length);
      if (change >= kJump && Jumps(arms, i - 1, k)) ++survey->jumps;
      if (std::abs(here[k]) < kArmOfSign) continue;
      const double sign = here[k] > 0 ? 1 : -1;
      if (sign * signs[k] < 0) ++changes[k];
      signs[k] = sign;
    }
    before = here;
  }
  const int most = *std::max_element(changes.begin(), changes.end());
  survey->most_sign_changes = std::max(survey->most_sign_changes, most);
  survey->lines_with_sign_change += most > 0 ? 1 : 0;
}

}  // namespace

PathSurvey SurveyArms(const ArmsAt& arms,
                      const Eigen::VectorXd& low,
                      const Eigen::VectorXd& high,
                      int lines,
                      std::uint32_t seed) {
  RandomDraws draws(seed);
  PathSurvey survey;
  survey.lines = lines;
  for (int i = 0; i < lines; ++i) {
    const Line line = DrawLine(low, high, &draws);
    FollowLine(ArmsAlong(arms, line), &survey);
  }
  return survey;
}

PathSurvey SurveyPath(const PathFunction& path, int lines, std::uint32_t seed) {
  return SurveyArms(
      [&](const Eigen::VectorXd& at) { return Evaluate(path, at).arms; },
      path.low,
      path.high,
      lines,
      seed);
}

}  // namespace musclewarp
