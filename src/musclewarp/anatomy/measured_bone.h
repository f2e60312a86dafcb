// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/anatomy/bone.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A bone with what anatomy asks of its shape.
struct MeasuredBone {
  Bone bone;

  // The ends of its long axis (LongAxis), 2 x 3, mm, in no order; none for a
  // mesh without area.
  Points ends;
};

MeasuredBone Measured(Bone bone);

}  // namespace musclewarp
