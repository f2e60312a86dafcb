// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

#include "musclewarp/label_images/label_image.h"

namespace musclewarp {

// The voxels of a label, and the least box that holds them.
struct LabelBox {
  Eigen::Array3i lowest, highest;  // both within the box
  std::int64_t voxels = 0;
};

// Returns the boxes of all labels but 0, by label.
std::map<int, LabelBox> BoxesOfLabels(const LabelImage& image);

// How many voxels a region has around it: enough for what smoothing spreads.
constexpr int kRegionMargin = 5;

// The voxels of which a surface is made: one piece without cavities.
struct LabelRegion {
  // The place of the first voxel of the region in the image. It may be negative
  // and the region may go beyond the image, as there are kRegionMargin voxels
  // of background on all sides: so labels that touch the border of the image
  // end there with a closed surface.
  Eigen::Array3i first;
  Eigen::Array3i size;
  std::vector<bool> is_inside;  // in the order of LabelImage::labels
  std::int64_t voxels = 0;      // that are inside

  int other_pieces = 0;            // that were left out
  std::int64_t other_voxels = 0;   // in these
  std::int64_t cavity_voxels = 0;  // that were filled
};

// Returns the largest piece of a label, without cavities. Voxels are of one
// piece if they share a corner, and voxels that are not of the piece are a
// cavity if no way through sides leads out of it: the marrow in the bark of a
// bone becomes a part of the bone, whatever label it has. Of pieces of one size
// the first counts. Precondition: `box` is that of the label.
LabelRegion RegionOfLabel(const LabelImage& image,
                          int label,
                          const LabelBox& box);

}  // namespace musclewarp
