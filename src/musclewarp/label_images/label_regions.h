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

// The voxels of which a surface is made: a piece without cavities.
struct LabelRegion {
  // The place of the first voxel of the region in the image. It may be negative
  // and the region may go beyond the image, as there are kRegionMargin voxels
  // of background on all sides: so labels that touch the border of the image
  // end there with a closed surface.
  Eigen::Array3i first;
  Eigen::Array3i size;
  std::vector<bool> is_inside;  // in the order of LabelImage::labels
  std::int64_t voxels = 0;      // that are inside

  std::int64_t cavity_voxels = 0;  // that were filled
};

// The pieces of a label. Voxels are of one piece if a way through faces of
// voxels leads from one to the other: what hangs together at an edge or a
// corner only has no closed surface of its own there.
struct LabelPieces {
  std::vector<LabelRegion> regions;  // the largest first; there is at least one

  // Other pieces, with fewer voxels than a surface can be made of
  // (kFewestVoxels), and the voxels in them.
  int small_pieces = 0;
  std::int64_t small_voxels = 0;
};

// A surface is made of at least so many voxels.
constexpr std::int64_t kFewestVoxels = 64;

// Returns the pieces of a label, each without cavities: voxels that are not of
// the piece are a cavity if no way through faces leads out of it. The marrow in
// the bark of a bone becomes a part of the bone, whatever label it has. Of
// pieces of one size the first comes first. Precondition: `box` is that of the
// label.
LabelPieces PiecesOfLabel(const LabelImage& image,
                          int label,
                          const LabelBox& box);

}  // namespace musclewarp
