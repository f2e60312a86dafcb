// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/motion/frame_solver.h"
#include "musclewarp/motion/prepared_scene.h"
#include "musclewarp/report/frame_record.h"

namespace musclewarp {

// What a run did, for report.json (docs/report.md describes the keys).
struct RunRecord {
  std::string solver;
  std::string command;                         // that runs it again
  std::map<std::string, std::string> options;  // all flags by name
  std::string inputs_hash;  // of all files read and options that matter
  const PreparedScene* scene = nullptr;
  ContactReport contact;
  SceneIntersections rest;  // of the meshes as they were delivered
  std::vector<FrameRecord> frames;
  int frames_planned = 0;
  bool finished = false;  // all frames are there
  std::string stopped;    // why, if not all ever will be; else empty
};

// Sums over the frames.
struct RunTotals {
  int frames = 0;
  int frames_clean = 0;           // no intersection
  double worst_volume_error = 0;  // largest |volume ratio - 1|
  int worst_folded_triangles = 0;
  double wall_ms_per_frame_median = 0;
  bool usable = false;
};

RunTotals TotalsOf(const RunRecord& run);

// The machine of this run.
nlohmann::ordered_json MachineJson();

// What is wrong with a mesh as delivered.
nlohmann::ordered_json DefectsJson(const MeshDefects& defects);

nlohmann::ordered_json ReportJson(const RunRecord& run);

}  // namespace musclewarp
