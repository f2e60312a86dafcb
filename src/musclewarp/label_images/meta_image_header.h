// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/label_images/image_grid.h"

namespace musclewarp {

// Reads the header of a MetaImage (.mha, or .mhd with the data in another
// file), because the vtkMetaImageReader of VTK 9.1 ignores the directions of
// the axes and truncated data.
//
// The grid is in LPS, the frame of ITK, which writes these files: row i of
// TransformMatrix is the direction of axis i, Offset is the centre of the first
// voxel. Lengths are in `mm_per_unit`: MetaImage has no field for
// their unit that programs agree on.
//
// Throws InputError that names the field for a file that is not a MetaImage,
// does not have three dimensions, has several channels, has a type whose size
// depends on the machine (MET_LONG), is split over several files, or is
// truncated.
ImageGrid ReadMetaImageHeader(const std::string& path, double mm_per_unit = 1);

}  // namespace musclewarp
