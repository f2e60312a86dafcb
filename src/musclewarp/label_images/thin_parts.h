// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "musclewarp/label_images/label_regions.h"

namespace musclewarp {

// Returns the voxels of thin parts that the level set of a smoothed region
// would cut off, ascending: for example a tendon of one or two voxels, with
// everything beyond it. `smoothed` has a value for each voxel of the region;
// voxels above the level are inside the surface. The largest connected part
// inside is kept. Any other part of the region is cut off if it extends more
// than two voxels from the kept part; the rims that smoothing removes do not.
std::vector<std::int64_t> VoxelsCutOff(const LabelRegion& region,
                                       const float* smoothed,
                                       double level);

}  // namespace musclewarp
