// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "musclewarp/page/measured_arms.h"
#include "musclewarp/page/recorded_run.h"

namespace musclewarp {

// How a page shows its runs.
struct PageOptions {
  // The number of triangles, about, to which the mesh of a bone is simplified
  // for display. Counts of crossing triangles are always of the whole mesh.
  int max_bone_triangles = 6000;
  // How the axes of the meshes lie in the body, and the side of the body that
  // "lateral" refers to (see ParseView in geometry/view.h). If empty, the
  // report of the first run decides.
  std::string axes;
  std::string side;
  // How far a coordinate of a muscle's vertex may be off, mm in a human; half
  // of it at rest.
  double position_tolerance = 0.02;
  // Laid over the moment arms of the runs.
  MeasuredArms measured;
  // The table of path functions (PathTableOf), or null.
  nlohmann::ordered_json path_table;
};

// What the page shows, in two parts that the scripts in tools/report/src/data
// read: texts and figures as JSON, and positions and indices as packed numbers
// to which the JSON refers. Positions of bones are rounded to 2^-17 of the
// diagonal of the scene, some micrometres.
struct PageContents {
  nlohmann::ordered_json json;
  // The packed numbers of all runs (see PackedNumbers), as base64.
  std::string numbers;
};

// Returns the coordinates and muscles of runs to which measured arms may
// belong.
ArmsOfRun ArmsOf(const std::vector<RecordedRun>& runs);

// Collects the data of a page. Runs are labelled by the last part of their
// folders, or by the whole path if that is not unique. Throws InputError that
// names --axes or --side. Precondition: there is at least one run.
PageContents PageContentsOf(const std::vector<RecordedRun>& runs,
                            const PageOptions& options);

}  // namespace musclewarp
