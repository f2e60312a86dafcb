// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "musclewarp/run/run_reader.h"

namespace musclewarp {

// A coordinate of the model of a run.
struct TableCoordinate {
  std::string name;
  std::string unit;    // "degrees", "m", or empty if it has none
  bool moves = false;  // in the motion of the run
};

// Returns the coordinates that the report of a run (ReadReport) lists; none for
// a run without a model. Throws InputError that names the field if it is
// damaged.
std::vector<TableCoordinate> TableCoordinatesOf(const JsonField& report);

// Returns a run as one table in CSV (RFC 4180), for spreadsheets and
// statistics: a row for each of `frames` (indices into run.frames), muscle and
// line, in this order, and one without a line for a muscle that has none. The
// columns, whose names end in their units, are in docs/export.md. What is not
// known is an empty field: the time of poses that are no motion, and moment
// arms that the run does not have or that did not converge.
//
// Names are those of the run but for SpreadsheetField(). `on_frame` is called
// before a frame is read. Throws InputError that names the file if a mesh or
// the lines of a frame are missing or damaged.
std::string RunTableText(const RunOutline& run,
                         const std::vector<TableCoordinate>& coordinates,
                         const std::vector<int>& frames,
                         const std::function<void(int frame)>& on_frame);

// Returns the largest area of a section of a muscle in a pose, mm^2, by 100
// planes at right angles to the mean of its lines, or to its long axis if it
// has none (plane_section.h). Precondition: the surface is a closed manifold,
// oriented outward.
double LargestSectionOfMuscle(const TriangleSoup& muscle,
                              const std::vector<NamedLine>& lines);

}  // namespace musclewarp
