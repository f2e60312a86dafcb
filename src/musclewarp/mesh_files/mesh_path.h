// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace musclewarp {

// A path of a mesh names a file, "muscles.obj", or one of the named parts of a
// file (mesh_parts.h), "muscles.obj#gluteus_medius".
struct MeshPath {
  std::string file;
  std::optional<std::string> part;  // empty: the whole file
};

// Takes a path apart. One under which there is a file is that file, even if it
// has a "#". Otherwise the file ends before the first "#" where there is one,
// or else where the name of a mesh file would end.
MeshPath SplitMeshPath(const std::string& path);

// Returns the file of a path, for what concerns its bytes.
std::string MeshFileOf(const std::string& path);

// Returns what the mesh is called: the name of its part, or that of the file
// without folder and extension.
std::string MeshNameOf(const std::string& path);

// Returns the path from `folder` on (PathFrom), with its part.
std::string MeshPathFrom(const std::string& folder, const std::string& path);

}  // namespace musclewarp
