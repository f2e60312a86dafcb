// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/run/run_reader.h"

namespace musclewarp {

// How frames are exported for finite elements; the fields are flags of
// musclewarp-export.
struct ElementOptions {
  std::string mesher = "tetgen";  // see FindMesher
  double mesher_timeout_s = 600;  // for each frame
  double min_dihedral_deg = 0;    // frames with a smaller angle fail
  bool bones = true;              // as rigid surfaces
  bool one_mesh = false;          // that of the first frame, moved
  bool resume = false;            // keep the frames that are there
};

// The formats for finite elements in this build.
const std::vector<std::string>& ElementFormats();

// Writes some frames of a run, by their numbers in run.frames, as meshes of
// tetrahedra to DIR/frame_0000.<format>, and what became of each to
// DIR/export.json. A frame fails, and has no file, if its meshes cross, the
// mesher gives none, or its quality is not as asked for. Returns an exit code:
// kExitNotUsable if a frame failed. Throws InputError for bad options, before
// anything is written.
int ExportElements(const RunOutline& run,
                   const std::vector<int>& frames,
                   const std::vector<std::string>& formats,
                   const ElementOptions& options,
                   const std::string& dir,
                   std::ostream& screen);

}  // namespace musclewarp
