// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Areas of attachment kept in a file of their own, beside the meshes they
// belong to:
//
//   { "units": "mm",
//     "muscles": { "iliacus_r": {
//       "origin": [ { "set": "ILIOR", "points": [[x,y,z], ...] }, ... ],
//       "insertion": [ ... ] } } }
//
// Other keys are passed over. `bodies` says which body the areas under a key of
// a muscle follow ("origin" -> "pelvis"); keys that it does not name are left
// out. By muscle; `radius` in mm. Throws InputError as ReadScene does.
std::map<std::string, std::vector<Attachment>> ReadAttachmentsFile(
    const std::string& path,
    const std::map<std::string, std::string>& bodies,
    double radius);

}  // namespace musclewarp
