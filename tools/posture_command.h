// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>

#include "musclewarp/mesh_repair/repair.h"

namespace musclewarp {

struct PostureOptions {
  // The mesh of a muscle as it was segmented in a posture.
  std::string posture;

  // What is compared with it: a mesh file, or else a muscle in a frame of a run
  // of musclewarp-deform ("last", a number, or empty for the last).
  std::string mesh;
  std::string in;
  std::string frame;
  std::string muscle;

  std::string out;  // folder for posture.json and the coloured mesh, or empty
  double spacing = 0;  // SurfaceComparisonOptions::spacing, mm
  RepairOptions repair = {};
};

// Compares a muscle in a frame with a mesh of the same muscle that was
// segmented in that posture: distances of the surfaces, volumes and their
// overlap. Both meshes are repaired as those of scenes are, and have to be
// closed then. Prints a table; with an output folder also writes posture.json
// (docs/report.md), and in a build with VTK posture.vtp, the muscle with the
// distance of each vertex as "distance_mm". Returns 0. Throws InputError,
// before anything is written, for bad input.
int PostureCommand(const PostureOptions& options, std::ostream& screen);

}  // namespace musclewarp
