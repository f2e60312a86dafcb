// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mesh_files/mesh_parts.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Return the mesh of a muscle or bone as delivered, in memory or in a file, in
// the rest pose and in mm. Remarks of the reader for the user are appended to
// `notes`; `parts`, unless null, is set to the named parts of a file. Throw
// InputError if the file cannot be read.
TriangleSoup DeliveredMesh(const SceneMuscle& muscle,
                           std::vector<std::string>* notes,
                           MeshParts* parts = nullptr);
TriangleSoup DeliveredMesh(const SceneBone& bone,
                           std::vector<std::string>* notes);

}  // namespace musclewarp
