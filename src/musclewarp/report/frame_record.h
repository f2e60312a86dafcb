// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/motion/frame.h"
#include "musclewarp/motion/prepared_scene.h"

namespace musclewarp {

// The figures of a muscle in one frame; docs/report.md says what each is.
struct MuscleRecord {
  std::string name;
  double volume_mm3 = 0;
  double volume_ratio = 0;
  double max_step_mm = 0;
  double max_displacement_mm = 0;
  double min_gap_mm = 0;
  int folded_triangles = 0;
  int self_pairs = 0;
  // With certified contact.
  double max_contact_displacement_mm = 0;
  double mean_contact_displacement_mm = 0;
  double depth_without_contact_mm = 0;
  int iterations = 0;
  double solve_ms = 0;
  double initial_energy_mm2 = 0;
  double final_energy_mm2 = 0;
  std::string stop_reason;
  std::map<std::string, double> line_lengths_mm;  // as carried by the muscle
  std::map<std::string, double> path_lengths_mm;  // straight
  std::vector<double> fibre_lengths_mm;
};

// The figures of a frame: what is left of it when its meshes are written.
struct FrameRecord {
  int index = 0;
  std::string name;
  double time = 0;
  std::map<std::string, double> coordinates;
  double wall_ms = 0;
  double solve_ms = 0;
  double certify_ms = 0;
  int pose_steps = 1;
  int iterations = 0;
  std::string stop_reason;
  bool usable = false;
  std::vector<std::string> shortcomings;
  std::vector<MuscleRecord> muscles;
  // By line and coordinate, mm/rad (or mm/m), of straight paths.
  std::map<std::string, std::map<std::string, double>> path_moment_arms_mm;
  SceneIntersections intersections;  // without lists

  double WorstVolumeError() const;
  int FoldedTriangles() const;
};

FrameRecord RecordOf(const PreparedScene& scene, const Frame& frame);

// An entry of "frames" in report.json, and back, to the last bit.
nlohmann::ordered_json ToJson(const FrameRecord& record);
FrameRecord FrameRecordFromJson(const nlohmann::ordered_json& json);

nlohmann::ordered_json ToJson(const SceneIntersections& intersections);

}  // namespace musclewarp
