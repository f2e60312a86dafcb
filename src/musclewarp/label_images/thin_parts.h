// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "musclewarp/label_images/label_regions.h"

namespace musclewarp {

// Returns the voxels of thin parts that the surface of a smoothed region at a
// level would cut off, ascending: a tendon of one or two voxels, for example,
// with all that lies beyond it. `smoothed` has a value for each voxel of the
// region, and voxels above the level are inside the surface. The largest part
// that hangs together inside it stays; what is left of the region goes on from
// there, and a part of it is cut off if it reaches farther than two voxels.
// Rims that smoothing takes off are not.
std::vector<std::int64_t> VoxelsCutOff(const LabelRegion& region,
                                       const float* smoothed,
                                       double level);

}  // namespace musclewarp
