// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "musclewarp/label_images/nrrd_header.h"

namespace musclewarp {

// The values of the voxels of an NRRD file, in the order of the file.
struct NrrdVoxels {
  std::string bytes;
  ScalarType type = ScalarType::kUInt8;
  ByteOrder order = ByteOrder::kLittle;

  double At(std::int64_t voxel) const {
    return LoadReal(bytes.data() + voxel * SizeOf(type), type, order);
  }
};

// Reads and decompresses `count` values. Throws InputError, which names the
// file, if it is truncated or damaged, or has text that is not a number.
// Precondition: the files exist.
NrrdVoxels ReadNrrdVoxels(const NrrdSource& source, std::int64_t count);

}  // namespace musclewarp
