// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/label_images/image_grid.h"

namespace musclewarp {

// Reads the header of a MetaImage (.mha, or .mhd with the data in another file)
// for what VTK 9.1 passes over: its vtkMetaImageReader ignores where the axes
// point, and data that end early.
//
// The grid is in LPS, the frame of ITK, which writes these files: row i of
// TransformMatrix is the direction of axis i, Offset is the centre of the first
// voxel. Lengths are in `mm_per_unit`: MetaImage has no field for
// their unit that programs agree on.
//
// Throws InputError that names the field for a file that is no MetaImage, has
// not three dimensions or several channels, is of a type whose size depends on
// the machine (MET_LONG), is split over several files, or ends early.
ImageGrid ReadMetaImageHeader(const std::string& path, double mm_per_unit = 1);

}  // namespace musclewarp
