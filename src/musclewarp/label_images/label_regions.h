// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <vector>

#include "musclewarp/label_images/label_image.h"

namespace musclewarp {

// The bounding box of the voxels of a label, and their number.
struct LabelBox {
  Eigen::Array3i lowest, highest;  // both within the box
  std::int64_t voxels = 0;
};

// Returns the boxes of all labels except 0, by label.
std::map<int, LabelBox> BoxesOfLabels(const LabelImage& image);

// The margin around a region, voxels: wide enough for smoothing.
constexpr int kRegionMargin = 5;

// The voxels from which a surface is made: a piece without cavities.
struct LabelRegion {
  // The index of the first voxel of the region in the image. It may be
  // negative, and the region may extend beyond the image, because it has a
  // margin of kRegionMargin background voxels on all sides. Hence labels that
  // touch the border of the image have a closed surface there.
  Eigen::Array3i first;
  Eigen::Array3i size;
  std::vector<bool> is_inside;  // in the order of LabelImage::labels
  std::int64_t voxels = 0;      // number of voxels inside

  std::int64_t cavity_voxels = 0;  // number of voxels filled
};

// The pieces of a label. Voxels belong to the same piece if they are connected
// through faces of voxels: voxels that touch only at an edge or a corner would
// have a non-manifold surface there.
struct LabelPieces {
  std::vector<LabelRegion> regions;  // the largest first; there is at least one

  // The number of other pieces, with fewer than kFewestVoxels voxels, and the
  // number of their voxels.
  int small_pieces = 0;
  std::int64_t small_voxels = 0;
};

// The smallest number of voxels for a surface.
constexpr std::int64_t kFewestVoxels = 64;

// Returns the pieces of a label, each without cavities: a cavity consists of
// voxels outside the piece from which no path through faces leads out of it.
// The marrow within the cortex of a bone becomes a part of the bone, whatever
// its label. Pieces of the same size are in the order of the image.
// Precondition: `box` is the box of the label.
LabelPieces PiecesOfLabel(const LabelImage& image,
                          int label,
                          const LabelBox& box);

}  // namespace musclewarp
