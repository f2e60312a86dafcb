// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/label_images/image_grid.h"

namespace musclewarp {

// An image whose voxels hold whole numbers, the labels of what is there; 0 is
// the background.
struct LabelImage {
  std::string path;
  ImageGrid grid;

  // The label of voxel (i, j, k), >= 0, is at (k * size[1] + j) * size[0] + i.
  std::vector<int> labels;

  // What the user has to know of how the file was read.
  std::vector<std::string> notes;
};

// Reads NIfTI (.nii, .nii.gz, pairs of .img and .hdr) and MetaImage (.mha,
// .mhd) with the readers of VTK, NRRD (.nrrd, .nhdr; nrrd_header.h) and images
// of FreeSurfer (.mgz, .mgh; mgh_image.h).
//
// Places are in millimetres and in LPS, whatever the format has. What VTK does
// not read of the frame is taken from the header
// (meta_image_header.h). NIfTI files are turned from RAS; of their two
// transforms the sform is taken if it is set, otherwise the qform, as nibabel
// does, and a note says so if they differ. A file with neither is not oriented,
// and a note says so. Slope and intercept of NIfTI are applied.
//
// `mm_per_unit` is the unit of files that do not state one, as MetaImage never
// does.
//
// Throws InputError, which names the file, for one that is missing, empty,
// damaged or truncated, that has more than kMostVoxels, more than one number a
// voxel or more than three dimensions, and for labels that are not whole
// numbers from 0 to 2147483647 (the message has the value and the voxel).
// Values within 1e-3 of one are that label, and a note says so.
LabelImage ReadLabelImage(const std::string& path, double mm_per_unit = 1);

}  // namespace musclewarp
