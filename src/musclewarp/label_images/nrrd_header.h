// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/label_images/image_grid.h"

namespace musclewarp {

// Reads the header of an NRRD file (teem.sourceforge.net/nrrd/format.html) for
// what VTK 9.1 passes over: its vtkNrrdReader ignores where the axes point,
// takes an axis of at most 9 voxels for the components of a vector, and fills
// up data that end early.
//
// The grid is in LPS. "space" right-anterior-superior is turned; a file that
// has no "space", or one that says nothing of the patient (scanner-xyz,
// 3D-right-handed), keeps its axes and is not oriented. "space units" m, cm, mm
// and um are converted; without them lengths are in `mm_per_unit`. Segments of
// 3D Slicer (Segment0_Name, and Segment0_LabelValue) give the names.
//
// Throws InputError that names the field for a file that is not NRRD, has not
// three dimensions, is left-handed, keeps its data in other files, is neither
// raw nor gzip, or whose raw data end early.
ImageGrid ReadNrrdHeader(const std::string& path, double mm_per_unit = 1);

}  // namespace musclewarp
