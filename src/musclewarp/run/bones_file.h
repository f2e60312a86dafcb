// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>

namespace musclewarp {

// The file of the bones of a frame whose meshes are in the rest folder only.
constexpr char kBonesFile[] = "bones.json";

// The rigid motions of bones from the rest pose, by the names of the bones:
// frame_from_rest, 4 x 4, translation in mm. Transformed() (mesh/transformed.h)
// takes the mesh of the rest folder to its place in the frame, to the last bit.
using BoneMotions = std::map<std::string, Eigen::Matrix4d>;

// Writes a bones file, to the last bit, in the form of the poses of a scene:
//
//   { "units": "mm", "bones": { "femur_r": [[r, r, r, x], [r, r, r, y],
//   [r, r, r, z], [0, 0, 0, 1]], ... } }
void WriteBonesFile(const std::string& path, const BoneMotions& bones);

// Reads a bones file. Throws InputError that names the file and the field.
BoneMotions ReadBonesFile(const std::string& path);

}  // namespace musclewarp
