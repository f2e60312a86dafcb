// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/opensim/model.h"

namespace musclewarp {

// Returns the folders in which the meshes of a model are looked for, in order:
// that of the model, the folder Geometry in it, where OpenSim looks, then
// `folders`, and last a folder Geometry in any folder above that of the model,
// where the models that come with OpenSim have theirs. Folders that do not
// exist are left out.
std::vector<std::string> GeometryFolders(
    const Model& model, const std::vector<std::string>& folders);

// Returns the path of the first file in these folders that a mesh of the model
// means, or an empty text if there is none. A file that the model names with
// an absolute path is looked for there first, and then by its name alone.
std::string FindGeometry(const ModelGeometry& geometry,
                         const std::vector<std::string>& folders);

// The same for a file that is needed. Throws InputError, which lists the
// folders that were searched, if it is not there.
std::string GeometryFile(const Model& model,
                         const ModelGeometry& geometry,
                         const std::vector<std::string>& folders);

}  // namespace musclewarp
