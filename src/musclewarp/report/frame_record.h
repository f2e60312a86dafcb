// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/base/stage_times.h"
#include "musclewarp/certificate/scene_intersections.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// The figures of a muscle in one frame that are kept once its mesh is written:
// an entry of "muscles" in report.json. docs/report.md explains each.
struct MuscleRecord {
  std::string name;
  double volume_mm3 = 0;
  double volume_ratio = 0;
  double volume_error = 0;
  double max_step_mm = 0;
  double max_displacement_mm = 0;
  double min_gap_mm = 0;
  int folded_triangles = 0;
  int self_pairs = 0;

  // What contact has done; zero without certified contact (see MuscleFrame).
  double max_contact_displacement_mm = 0;
  double mean_contact_displacement_mm = 0;
  double depth_without_contact_mm = 0;
  SurfacePatch torn_patch;
  double push_depth_mm = 0;
  std::vector<std::string> pushed_by;
  std::vector<AttachmentDrift> attachments;
  ShapeMeasures shape;

  // The solve. Energies are those of the linear rows, 1/2 |f|^2.
  int iterations = 0;
  double solve_ms = 0;
  double initial_energy_mm2 = 0;
  double final_energy_mm2 = 0;
  std::string stop_reason;

  // The lengths of the action lines by name: as the muscle carries them, and
  // straight through their path points.
  std::map<std::string, double> line_lengths_mm;
  std::map<std::string, double> path_lengths_mm;
  std::vector<double> fibre_lengths_mm;

  // StretchByFifths; empty without fibres.
  std::vector<double> fibre_stretch_by_fifths;

  // Their moment arms as the muscle carries them, mm/rad (or mm/m): of lines by
  // name and coordinate, of fibres by coordinate. Those of fibres leave out
  // coordinates by which no fibre is moved. Both are empty if there are none.
  std::map<std::string, std::map<std::string, double>> line_moment_arms_mm;
  std::map<std::string, std::vector<double>> fibre_moment_arms_mm;
};

// The figures of a frame that are kept once its meshes are written: an entry of
// "frames" in report.json.
struct FrameRecord {
  int index = 0;
  std::string name;
  double time = 0;
  std::map<std::string, double> coordinates;
  double wall_ms = 0;
  double solve_ms = 0;
  double certify_ms = 0;
  double moment_arms_ms = 0;
  std::vector<StageTime> stages;  // with --profile
  int pose_steps = 1;
  int iterations = 0;
  std::string stop_reason;
  bool usable = false;
  std::vector<std::string> shortcomings;
  std::vector<BoneOverlap> bone_overlaps;
  std::vector<DeliveredCrossing> delivered_crossings;
  std::vector<MuscleRecord> muscles;

  // The moment arms of straight paths, by line and coordinate, mm/rad (or
  // mm/m).
  std::map<std::string, std::map<std::string, double>> path_moment_arms_mm;
  bool moment_arms_converged = true;
  SceneIntersections intersections;  // without lists of triangles

  // The largest |volume_error| of a muscle, and the folded triangles of all.
  double WorstVolumeError() const;
  int FoldedTriangles() const;
};

// Returns the figures of a frame.
FrameRecord RecordOf(const PreparedScene& scene, const Frame& frame);

// Convert a record to its entry in report.json and back, without losing a bit.
nlohmann::ordered_json ToJson(const FrameRecord& record);
FrameRecord FrameRecordFromJson(const nlohmann::ordered_json& json);

// Returns an array "stages" of report.json.
nlohmann::ordered_json ToJson(const std::vector<StageTime>& stages);

// Returns an object "intersections" of report.json.
nlohmann::ordered_json ToJson(const SceneIntersections& intersections);

}  // namespace musclewarp
