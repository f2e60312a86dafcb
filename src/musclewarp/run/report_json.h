// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "musclewarp/figures/run_figures.h"
#include "musclewarp/frame_solvers/frame_solver.h"
#include "musclewarp/preparation/prepared_scene.h"

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
  std::vector<FrameFigures> frames;
  int frames_planned = 0;
  bool finished = false;  // true if all frames are there
  std::string stopped;    // why the run ended before that, or empty
};

// Sums up the frames of a run: "summary" in report.json.
RunFigures TotalsOf(const RunRecord& run);

// Returns "machine" of report.json, for this machine.
nlohmann::ordered_json MachineJson();

// Returns "defects" of a mesh as it was delivered.
nlohmann::ordered_json DefectsJson(const MeshDefects& defects);

// Returns "repairs" of a mesh: what was done to it.
nlohmann::ordered_json RepairsJson(const MeshPreparation& mesh);

// Returns all of report.json.
nlohmann::ordered_json ReportJson(const RunRecord& run);

}  // namespace musclewarp
