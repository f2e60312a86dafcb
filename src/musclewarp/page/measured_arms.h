// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/figures/frame_figures.h"

namespace musclewarp {

// A moment arm that someone has measured.
struct MeasuredArm {
  std::string joint;
  std::string coordinate;  // in its positive direction: "flexion"
  std::string muscle;
  // Empty: the source says of no angle for which it holds.
  std::optional<double> angle_deg;
  double arm_mm = 0;              // positive: turns the coordinate up
  std::optional<double> sd_mm;    // over subjects
  std::string source;             // whose, in words
  std::string method, condition;  // in words; empty if the table has none
  std::string detail;             // how it was measured and read, in words
};

// Measured moment arms from a CSV table. Rows without an arm (those that give
// ratios) are left out, and counted.
struct MeasuredArms {
  std::vector<MeasuredArm> arms;
  int rows_without_arm = 0;
};

// Reads a table with the columns coordinate, muscle and moment_arm_mm, and of
// joint, angle_deg, sd_mm, source, condition, method, doi_or_pmcid, where and
// read_as those that it has. Throws InputError that names the file and the
// line.
MeasuredArms ReadMeasuredArms(const std::string& path);

// A coordinate of a run, and which of its muscles measured arms are of.
struct ArmsOfRun {
  struct Coordinate {
    std::string name;
    double lowest_deg = 0;  // in the frames of the run
  };
  std::vector<Coordinate> coordinates;  // rotations that move
  std::vector<std::string> muscles;
};

// Returns the rotations that the motion of a report (report.json) moves.
template <class Json>
std::vector<std::string> MovingRotations(const Json& report) {
  std::vector<std::string> names;
  const Json motion = report.value("motion", Json());
  if (motion.is_null()) return names;
  for (const Json& coordinate : motion.at("coordinates")) {
    if (coordinate.at("moves").template get<bool>() &&
        coordinate.at("unit") == "degrees") {
      names.push_back(coordinate.at("name"));
    }
  }
  return names;
}

// Adds the muscles of a run and the rotations that move in it (MovingRotations)
// to `arms`, unless they are there.
void AddArms(const std::vector<std::string>& rotations,
             const std::vector<FrameFigures>& frames,
             ArmsOfRun* arms);

// Where a measured arm belongs in a run.
struct ArmPlace {
  std::string coordinate;
  std::vector<std::string> muscles;
  // The coordinate of the run counts the other way: angle and arm change sign.
  bool turned = false;
};

// Finds the coordinate by its name without side ("hip_flexion_r", "flexion"),
// or by the names that OpenSim's models use (knee_angle, ankle_angle,
// subtalar_angle, hip_rotation, arm_flex, arm_add, arm_rot), which count
// dorsiflexion and shoulder adduction positive. A knee that goes below -20
// degrees counts flexion negative. A measured arm is of each muscle whose name
// has all its words, in any order: "psoas" of psoas_major_r; that of the
// Achilles tendon is of soleus and gastrocnemius, where the run has any.
// Returns nothing if the run has no such coordinate or muscle.
std::optional<ArmPlace> PlaceOf(const MeasuredArm& arm, const ArmsOfRun& run);

// Returns a sentence that says how many of the arms belong to the run, and why
// others do not.
std::string MeasuredNote(const MeasuredArms& measured, const ArmsOfRun& run);

}  // namespace musclewarp
