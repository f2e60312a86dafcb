// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/frame_solvers/frame_solver.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/report/frame_record.h"

namespace musclewarp {

// Everything about a run that goes into report.json (docs/report.md explains
// the keys).
struct RunRecord {
  // The folder of the run, from which the paths in the report lead. If empty,
  // paths are as they were given.
  std::string dir;

  std::string solver;
  std::string command;  // that repeats the run, called in its folder
  std::map<std::string, std::string> options;  // all flags by name
  std::string inputs_hash;  // over all input files and the options that matter
  const PreparedScene* scene = nullptr;
  ContactReport contact;
  SceneIntersections rest;  // of the meshes as they were delivered
  std::vector<FrameRecord> frames;
  int frames_planned = 0;
  bool finished = false;  // true if all frames are there
  std::string stopped;    // why the run ended before that, or empty
};

// What the frames of a run come to: "summary" in report.json.
struct RunTotals {
  int frames = 0;
  int frames_clean = 0;           // frames without an intersection
  double worst_volume_error = 0;  // largest |volume ratio - 1|
  int worst_folded_triangles = 0;
  double wall_ms_per_frame_median = 0;
  bool usable = false;
};

// Sums up the frames of a run.
RunTotals TotalsOf(const RunRecord& run);

// Returns "machine" of report.json, for this machine.
nlohmann::ordered_json MachineJson();

// Returns "defects" of a mesh as it was delivered.
nlohmann::ordered_json DefectsJson(const MeshDefects& defects);

// Returns "repairs" of a mesh: what was done to it.
nlohmann::ordered_json RepairsJson(const MeshPreparation& mesh);

// Returns all of report.json.
nlohmann::ordered_json ReportJson(const RunRecord& run);

}  // namespace musclewarp
