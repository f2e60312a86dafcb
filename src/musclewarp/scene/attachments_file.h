// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Reads attachment areas from a separate file, which accompanies the meshes:
//
//   { "units": "mm",
//     "muscles": { "iliacus_r": {
//       "origin": [ { "set": "ILIOR", "points": [[x,y,z], ...] }, ... ],
//       "insertion": [ ... ] } } }
//
// Returns the areas of each muscle by its name, all with the radius `radius`
// (mm). `bodies` maps the keys of a muscle to the bodies that the areas under
// these keys follow ("origin" -> "pelvis"). Areas under other keys, and all
// other keys of the file, are ignored. Throws InputError as ReadScene does.
std::map<std::string, std::vector<Attachment>> ReadAttachmentsFile(
    const std::string& path,
    const std::map<std::string, std::string>& bodies,
    double radius);

}  // namespace musclewarp
