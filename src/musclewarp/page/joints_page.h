// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/joints/articulation.h"

namespace musclewarp {

// What the page of joints shows of them.
struct JointsPageOptions {
  std::string name;  // the title of the page
  // Where +x, +y and +z of the frame of the bones point; if empty, the first
  // joint that was found tells where forward, up and right are.
  std::string axes;
  // As PageOptions::max_bone_triangles.
  int max_bone_triangles = 6000;
};

// Returns the page of the joints of a skeleton as a single HTML text that needs
// no server and no other file: its report (joints.json), the bones with the
// shapes that were fitted to them, and the coordinates to be turned. Names and
// reasons are escaped, so they cannot end the script that holds them. The text
// is the same for the same joints.
std::string JointsPageHtml(const Articulation& articulation,
                           const JointsPageOptions& options);

}  // namespace musclewarp
