// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/frames/frame.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// The result of one solver configuration for one pose: a row of the tables that
// musclewarp-compare writes.
struct ComparisonRow {
  int frame = 0;
  std::string pose;
  std::string configuration;
  std::string contact;  // "none", "paper/coarse", ...
  std::string stop_reason;

  // False if the configuration could not be run; the fields below are then
  // undefined.
  bool was_run = false;
  int iterations = 0;  // of all muscles, or of the group if it has contact
  double ms = 0;       // in the solver; the median of the repeats
  double ms_per_iteration = 0;
  double time_ratio = 0;    // to the reference with the same contact
  double final_cost = 0;    // 1/2 |f|^2 of all muscles, mm^2
  double cost_ratio = 0;    // to the reference with the same contact
  double volume_ratio = 0;  // to the prescribed volume; farthest from 1
  double distance = 0;      // the largest of a vertex to the reference, mm

  // The distance of a fine vertex to the shape without contact, mm.
  double largest_contact_move = 0;
  double mean_contact_move = 0;
  int folded_triangles = 0;
  SceneIntersections intersections;
  std::vector<SolverSummary> muscles;
};

// Returns the row of a frame. Compares it with the frame of the reference
// solver in the same pose and with the same contact, and with the frame without
// contact; either may be null. `counts_together` says that each muscle of the
// frame counts the iterations of all.
ComparisonRow RowOf(const Frame& frame,
                    const Frame* reference,
                    const Frame* without_contact,
                    bool counts_together);

// Prints the rows as a table for the screen.
void PrintComparison(const std::vector<ComparisonRow>& rows, std::ostream& out);

// Return the rows as CSV, one line each, and the convergence history, one line
// for each iteration of a muscle.
std::string ComparisonCsv(const std::vector<ComparisonRow>& rows);
std::string HistoryCsv(const std::vector<ComparisonRow>& rows,
                       const PreparedScene& scene);

// Returns comparison.json, with the history of every muscle.
nlohmann::ordered_json ComparisonJson(const std::vector<ComparisonRow>& rows,
                                      const PreparedScene& scene);

}  // namespace musclewarp
