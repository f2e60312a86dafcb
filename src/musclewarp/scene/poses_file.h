// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Lines and poses kept in a file of their own, beside the meshes they belong
// to:
//
//   { "units": "mm",
//     "lines": { "glut_med1_r": { "rest": [[x,y,z], ...], "bodies": [...] } },
//     "poses": [ { "name": "flexion_60", "femur": [[4x4]],
//                  "target": { "glut_med1_r": [[x,y,z], ...] } } ] }
//
// Such files come with other keys (notes, who made them, shares); those are
// passed over. A pose's numbers are its coordinates; a pose without name is
// called by them ("hip_flexion_r_deg_60").
struct PosesFile {
  std::map<std::string, ActionLine> lines;
  std::vector<ScenePose> poses;
};

// `body_keys`: which key of a pose holds the transform of which bodies
// ("femur" -> "femur_r", "tibia_r"). Throws InputError as ReadScene does.
PosesFile ReadPosesFile(
    const std::string& path,
    const std::map<std::string, std::vector<std::string>>& body_keys);

}  // namespace musclewarp
