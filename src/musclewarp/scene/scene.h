// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// An area of a body where a muscle is attached: what lies within `radius` mm of
// one of `points` (#P x 3, rest pose, mm).
struct Attachment {
  std::string body;
  Points points;
  double radius = 0;
};

struct SceneMuscle {
  std::string name;
  std::string mesh_path;
  std::vector<ActionLine> lines;
  std::vector<Attachment> attachments;
};

struct SceneBone {
  std::string name;
  std::string mesh_path;
  std::string body;
};

// One instant of the motion.
struct ScenePose {
  std::string name;
  double time = 0;                            // s
  std::map<std::string, double> coordinates;  // for the record only
  // target_from_rest, mm; a body that is not named stays.
  std::map<std::string, Eigen::Matrix4d> bodies;
  // Target points by line name; a line that is not named moves with its bodies.
  std::map<std::string, Points> lines;
};

// Muscles, bones and poses; meshes are named, not yet read. All positions are
// in the rest pose, in one frame, in millimetres.
struct Scene {
  std::string name;
  std::string path;
  std::vector<SceneMuscle> muscles;
  std::vector<SceneBone> bones;
  std::vector<ScenePose> poses;
};

// Reads a scene file (docs/scene.md). Paths in it are relative to `data_root`,
// or to the folder of the scene file if that is empty. Throws InputError that
// names the file and the field: not JSON, unknown key, missing key, wrong type,
// duplicate name, a body that nothing names, a line with too few or repeated
// points, rest and target of different length, a matrix that is not a rigid
// motion.
Scene ReadScene(const std::string& path, const std::string& data_root);

}  // namespace musclewarp
