// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/figures/frame_figures.h"
#include "musclewarp/run/recorded_pose.h"
#include "musclewarp/scene/json_fields.h"

namespace musclewarp {

// A frame of a run.
struct RecordedFrame {
  FrameFigures figures;
  std::string folder;  // empty if it is missing
};

// What report.json and the folders of a run say of it, without its meshes, so
// that these can be read pose by pose (recorded_pose.h).
struct RunOutline {
  std::string dir;
  std::string rest;  // the folder of the rest pose
  std::string scene;
  std::string version;      // of the program that wrote it
  std::string inputs_hash;  // of what the run was made from
  std::string axes;         // how the axes of the meshes lie in the body
  std::string side;         // of the body; empty if the report has none
  std::string contact;
  double body_size = 1;  // Scene::body_size
  bool is_finished = false;
  bool is_usable = false;
  RecordedNames names;
  std::vector<RecordedFrame> frames;

  // True if the times of the frames rise, which they do in a motion.
  bool has_times = false;

  // What a user should know of it.
  std::vector<std::string> warnings;
};

// Reads DIR/report.json. Throws InputError if there is no such folder, or if
// the file is missing or is not JSON.
JsonField ReadReport(const std::string& dir);

// Reads what a report says, whichever build has written it, and finds the
// folders of its frames. A frame that the report calls not usable stays so,
// even if its figures do not say why. Throws InputError that names the field if
// one is missing or damaged.
RunOutline OutlineOf(const std::string& dir, const JsonField& report);

// Leaves out frames whose folders are missing, with a warning each.
void DropMissingFrames(RunOutline* run);

// Returns the outline of a run for another program, with the frames that are
// there; warns if the run is not finished or not usable, or of another version
// than that of this program. Throws InputError as the functions above do, and
// if there is no frame.
RunOutline ReadRunForExport(const std::string& dir, const std::string& version);

// Returns what messages about a frame end with: in motions its time, such as
// ", at 0.07 s", else nothing.
std::string AtTime(const RunOutline& run, const RecordedFrame& frame);

}  // namespace musclewarp
