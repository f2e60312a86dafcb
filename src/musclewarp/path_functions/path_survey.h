// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

#include "musclewarp/path_functions/path_function.h"

namespace musclewarp {

// What moment arms do on straight lines through the range of a path function.
struct PathSurvey {
  int lines = 0;

  // Jumps of an arm: pieces of a line over which it changes by kJump or more,
  // to and fro together, with at least half of that in a sixteenth of the
  // piece.
  int jumps = 0;

  // Lines on which an arm changes its sign, with at least kArmOfSign on both
  // sides, and the most changes of one arm on a line. A muscle may pass over an
  // axis once; an arm that changes its sign again and again is a wave of the
  // polynomial.
  int lines_with_sign_change = 0;
  int most_sign_changes = 0;

  // The steepest change of an arm about one coordinate, mm per rad (or m) of
  // it, per rad (or m) along the line.
  double steepest = 0;
};

// The smallest arm that has a sign, and the smallest jump, mm per rad or m.
constexpr double kArmOfSign = 1;
constexpr double kJump = 0.5;

// The arms in a posture, mm per rad or m.
using ArmsAt = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

// Follows `lines` random lines, in 100 pieces each, from one end of the range
// to the other and a tenth of it beyond both ends, where functions go on
// linearly.
PathSurvey SurveyPath(const PathFunction& path, int lines, std::uint32_t seed);

// Does the same for arms of any kind, over a range of coordinates.
PathSurvey SurveyArms(const ArmsAt& arms,
                      const Eigen::VectorXd& low,
                      const Eigen::VectorXd& high,
                      int lines,
                      std::uint32_t seed);

}  // namespace musclewarp
