// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "musclewarp/label_images/image_grid.h"
#include "musclewarp/mesh_files/binary_scalar.h"

namespace musclewarp {

// An image of FreeSurfer (.mgh, or .mgz, which is the same in gzip): a header
// of 284 bytes and the voxels, the highest byte first.
struct MghImage {
  ImageGrid grid;  // in LPS, mm
  ScalarType type = ScalarType::kUInt8;
  std::string bytes;

  // The value of a voxel, in the order of LabelImage::labels.
  double At(std::int64_t voxel) const {
    const auto at = static_cast<std::size_t>(voxel) * SizeOf(type);
    return LoadReal(bytes.data() + at, type, ByteOrder::kBig);
  }
};

// Reads an image. An image without a frame has coronal slices of 1 mm with the
// origin in the middle, as in FreeSurfer, and its grid is not oriented. Throws
// InputError, which names the file, if it is not such an image, is truncated,
// has several time points, or a number type that FreeSurfer does not write, and
// as CheckGrid does.
MghImage ReadMghImage(const std::string& path);

}  // namespace musclewarp
