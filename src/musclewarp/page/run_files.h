// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace musclewarp {

// Mesh files by the name of what they show.
using MeshFiles = std::map<std::string, std::string>;

// A moment to draw.
struct FrameFiles {
  std::string name;  // "" if nothing tells
  MeshFiles meshes;
};

// What a folder holds.
struct RunFiles {
  std::vector<FrameFiles> frames;
  // From report.json, in its order; without one, has_report is false.
  bool has_report = false;
  std::vector<std::string> muscles;
  // How the axes of the meshes lie in the body (see geometry/view.h).
  std::string axes = "LPS";
  std::string side = "right";
};

// The meshes of a folder by stem; of several formats the most exact one is
// taken, .ply first.
MeshFiles MeshFilesIn(const std::string& dir);

// The frame folders (frame_0000, ...) of a run by number.
std::map<int, std::string> FrameFoldersIn(const std::string& dir);

// The frames of a folder that musclewarp-deform has written (frame_0000, ...,
// report.json), in the order of `frames`: numbers or "last", with commas. A
// folder without frame_0000 ... is one frame itself. Throws InputError that
// names what is missing.
RunFiles FindRunFiles(const std::string& dir, const std::string& frames);

}  // namespace musclewarp
