// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/run/recorded_pose.h"
#include "musclewarp/scene/scene_pose.h"

namespace musclewarp {

// A frame of a run whose files are there.
struct OutlinedFrame {
  int index = 0;  // the number of its folder
  std::string folder;
  ScenePose pose;  // its name and time
  bool usable = false;
};

// What a run of musclewarp-deform consists of, without its meshes, so that they
// can be read frame by frame.
struct RunOutline {
  std::string dir;
  std::string rest;  // the folder of the rest pose
  std::string scene;
  std::string inputs_hash;  // of what the run was made from
  std::string axes;         // how the axes of the meshes lie in the body
  std::string contact;
  RecordedNames names;
  std::vector<OutlinedFrame> frames;

  // True if the times of the frames rise, which they do in a motion.
  bool has_times = false;

  // What a user should know: the run is not finished or not usable, is of
  // another version, or frames are missing.
  std::vector<std::string> warnings;
};

// Reads report.json of a run and finds its frames. `version` is that of this
// program. Throws InputError that names the file and the field if the folder or
// the report is missing or damaged, or if there is no frame.
RunOutline ReadRunOutline(const std::string& dir, const std::string& version);

// Returns what messages about a frame end with: in motions its time, such as
// ", at 0.07 s", else nothing.
std::string AtTime(const RunOutline& run, const OutlinedFrame& frame);

}  // namespace musclewarp
