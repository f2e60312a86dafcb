// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/certified_contact/contact_step.h"

namespace musclewarp {

// Returns the longest distance, mm, that a step would carry a vertex beyond the
// first hit of its path with a bone; zero if there is none. Paths are straight
// in the frame of the bone. Vertices of triangles that may cross the bone are
// ignored.
//
// Planes hold only vertices near a bone. In a long step a distant muscle may
// pass through a bone without leaving a crossing; this function detects it.
double MaxTunnelling(const ContactStep& step);

}  // namespace musclewarp
