// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/page/measured_arms.h"

namespace musclewarp {

// Which arms of a muscle are held against measured ones.
enum class ArmKind {
  kPath,     // of its lines
  kCarried,  // of its lines as the mesh carries them
};

// How the arms of a muscle compare with measured ones, as one kind.
struct ArmVerdict {
  double low_mm = 0, high_mm = 0;  // at the angles of the measured arms

  // The part of the measured angles at which the arm lies in the band: the
  // range of all studies near that angle, widened by a tenth of its size, or
  // 30 % to both sides of a single study.
  double inside = 0;
  bool has_sign = false;  // wherever all measured arms have one

  // Whether it changes in the direction in which most studies found it to
  // change; nothing if they found no change of 3 mm.
  std::optional<bool> has_trend;

  bool Holds() const {
    return inside == 1 && has_sign && has_trend.value_or(true);
  }
};

// The arms of one muscle of a run about one coordinate, beside measured ones.
struct ScoredMuscle {
  std::string muscle;      // of the run
  std::string measured;    // of the table
  std::string coordinate;  // of the run
  bool turned = false;  // as ArmPlace::turned; angles and arms are as measured
  int values = 0;       // measured arms within the motion
  int studies = 0;
  double first_deg = 0, last_deg = 0;  // of these
  double measured_low_mm = 0, measured_high_mm = 0;
  ArmVerdict path, carried;
};

// Compares the arms of the frames of a run, the mean over the lines of each
// muscle, with measured arms that give an angle within the motion. Arms during
// the largest contraction ("MVC") are left out, as no model of relaxed muscles
// has them. Muscles are in the order of the run.
std::vector<ScoredMuscle> ScoreArms(const MeasuredArms& measured,
                                    const ArmsOfRun& run,
                                    const std::vector<FrameFigures>& frames);

}  // namespace musclewarp
