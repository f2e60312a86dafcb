// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/label_images/image_grid.h"

namespace musclewarp {

// An image whose voxels are integers, the labels of structures; 0 is the
// background.
struct LabelImage {
  std::string path;
  ImageGrid grid;

  // The label of voxel (i, j, k), >= 0, is at (k * size[1] + j) * size[0] + i.
  std::vector<int> labels;

  // Remarks for the user about the reading of the file.
  std::vector<std::string> notes;
};

// Reads NIfTI (.nii, .nii.gz, pairs of .img and .hdr) and MetaImage (.mha,
// .mhd) with the readers of VTK, NRRD (.nrrd, .nhdr; nrrd_header.h) and images
// of FreeSurfer (.mgz, .mgh; mgh_image.h).
//
// Positions are in millimetres and in LPS, regardless of the format. The parts
// of the frame that VTK does not read are taken from the header
// (meta_image_header.h). NIfTI files are converted from RAS; of their two
// transforms the sform is used if it is set, otherwise the qform, as in
// nibabel, and a note reports a difference between them. A file with neither is
// not oriented, which a note reports. Slope and intercept of NIfTI are applied.
//
// `mm_per_unit` is the unit of files that state none, as MetaImage files never
// do.
//
// Throws InputError, which names the file, if it is missing, empty, damaged or
// truncated, has more than kMostVoxels, several numbers per voxel or more than
// three dimensions, or has labels that are not integers from 0 to 2147483647
// (the message has the value and the voxel). Values within 1e-3 of an integer
// are rounded, which a note reports.
LabelImage ReadLabelImage(const std::string& path, double mm_per_unit = 1);

}  // namespace musclewarp
