// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

namespace musclewarp {

// Compares the two transforms of a NIfTI file, from the index of a voxel to its
// position in RAS, at the corners of an image of `size` voxels. Returns a
// sentence about the file if they differ by more than 0.1 voxels at any corner,
// and "" otherwise.
std::string NoteOnOtherQform(const std::string& path,
                             const Eigen::Array3i& size,
                             const Eigen::Matrix4d& sform,
                             const Eigen::Matrix4d& qform);

}  // namespace musclewarp
