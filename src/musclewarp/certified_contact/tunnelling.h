// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/certified_contact/contact_step.h"

namespace musclewarp {

// Returns the longest way, mm, on which a step would carry a vertex after it
// has run into a bone; zero if none does. Ways are straight in the frame of the
// bone, and those of triangles that may cross it do not count.
//
// Planes hold the vertices that are near a bone. In a long step a muscle that
// is not may pass through a bone and leave no crossing behind: this tells.
double MaxTunnelling(const ContactStep& step);

}  // namespace musclewarp
