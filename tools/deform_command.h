// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "musclewarp/motion/prepared_scene.h"
#include "musclewarp/motion/scene_contact.h"
#include "musclewarp/solver/muscle_target.h"
#include "tools/solver_configuration.h"

namespace musclewarp {

enum class DeformContact { kNone, kPaper };

struct DeformOptions {
  std::string scene;
  std::string data_root;  // empty: the folder of the scene
  std::string out;
  SolverConfiguration solver = SolverConfigurationNamed("ceres");
  DeformContact contact = DeformContact::kNone;
  std::string frames = "all";  // "all", "last", "7" or "first:last[:step]"
  std::vector<std::string> formats = {"ply"};
  int threads = 0;  // 0: as many as OpenMP chooses

  PrepareOptions prepare;
  PreRotationOptions pre_rotation;
  SceneContactOptions scene_contact;
};

// Names of flags to values; InputError names the flag and what is allowed.
SolverConfiguration ParseSolver(const std::string& text);
DeformContact ParseDeformContact(const std::string& text);
ContactLevel ParseContactLevel(const std::string& text);
std::vector<std::string> ParseFormats(const std::string& text);

// Indices of the poses that `frames` selects out of `count`, rising. "a:b:step"
// runs from a to b inclusive.
std::vector<int> SelectFrames(const std::string& frames, int count);

// Throw InputError: options that no scene can be run with, a folder that cannot
// be written (it is not made), one that cannot be made.
void CheckSceneOptions(const DeformOptions& options);
void CheckWritable(const std::string& dir);
void MakeFolder(const std::string& dir);

// Deforms the muscles of a scene in every selected pose, writes the frames and
// report.json to `out` and a summary to `screen`. Returns an exit code. Throws
// InputError, before anything is written, for bad input.
int DeformCommand(const DeformOptions& options, std::ostream& screen);

}  // namespace musclewarp
