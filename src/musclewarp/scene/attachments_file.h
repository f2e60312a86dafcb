// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Reads attachment areas from a file of their own, which stands beside the
// meshes it belongs to:
//
//   { "units": "mm",
//     "muscles": { "iliacus_r": {
//       "origin": [ { "set": "ILIOR", "points": [[x,y,z], ...] }, ... ],
//       "insertion": [ ... ] } } }
//
// The result maps names of muscles to their areas, all of which get the radius
// `radius` (mm). `bodies` says which body the areas under a key of a muscle
// follow ("origin" -> "pelvis"); areas under keys that it does not name are
// left out, and so are all other keys of the file. Throws InputError as
// ReadScene does.
std::map<std::string, std::vector<Attachment>> ReadAttachmentsFile(
    const std::string& path,
    const std::map<std::string, std::string>& bodies,
    double radius);

}  // namespace musclewarp
