// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Lines and poses from a separate file, which accompanies the meshes:
//
//   { "units": "mm",
//     "lines": { "glut_med1_r": { "rest": [[x,y,z], ...], "bodies": [...] } },
//     "poses": [ { "name": "flexion_60", "femur": [[4x4]],
//                  "target": { "glut_med1_r": [[x,y,z], ...] } } ] }
//
// Other keys of such a file (notes, author) are ignored. The numbers of a pose
// are its coordinates, and a pose without a name is named after them
// ("hip_flexion_r_deg_60").
struct PosesFile {
  std::map<std::string, ActionLine> lines;  // by name
  std::vector<ScenePose> poses;             // in the order of the file
};

// Reads such a file. `body_keys` maps the keys of a pose that hold transforms
// to the bodies that follow them ("femur" -> "femur_r", "tibia_r"); every pose
// must have all of these keys. Throws InputError as ReadScene does.
PosesFile ReadPosesFile(
    const std::string& path,
    const std::map<std::string, std::vector<std::string>>& body_keys);

}  // namespace musclewarp
