// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace musclewarp {

// The largest number of voxels in an image, such as 800 x 800 x 780: the labels
// take 4 bytes each in memory, in addition to the content of the file.
constexpr std::int64_t kMostVoxels = 500000000;

// The positions of the voxels of an image, as in the header of its file.
struct ImageGrid {
  Eigen::Array3i size = Eigen::Array3i::Zero();  // voxels along i, j and k

  // The transform from the index (i, j, k, 1) of a voxel, counted from 0 in the
  // order of the file, to the position of its centre, mm. Its columns are the
  // steps from voxel to voxel, so that they contain the spacing and the
  // direction of each axis.
  Eigen::Matrix4d world_from_index = Eigen::Matrix4d::Identity();

  // True if +x, +y and +z of positions point to the left, the back and the head
  // of the patient (LPS), false if the file does not state their directions.
  bool is_oriented = false;

  // The names of labels, if the file has them, as .seg.nrrd does.
  std::map<int, std::string> names;

  std::int64_t NumVoxels() const;
  double VoxelVolume() const;  // mm^3
};

// Converts a grid from RAS (right, front, head, as in NIfTI) to LPS.
void TurnFromRas(ImageGrid* grid);

// Throws InputError, naming `path`, unless every axis has at least one voxel,
// there are at most kMostVoxels, the steps are 0.001 to 100 mm long and
// linearly independent, and the image is within 1e7 mm of the origin.
void CheckGrid(const std::string& path, const ImageGrid& grid);

// Throws InputError unless a file has at least `bytes` bytes of data, starting
// at byte `begin`.
void CheckDataSize(const std::string& path,
                   std::uint64_t begin,
                   std::uint64_t bytes);

// Returns the numbers in a text, separated by blanks, commas and parentheses.
// Throws InputError, naming `where`, unless there are `count`, all finite.
std::vector<double> HeaderNumbers(const std::string& where,
                                  std::string_view text,
                                  std::size_t count);

// Returns the three sizes of an image in a text, which must be integers.
Eigen::Array3i HeaderSizes(const std::string& where, std::string_view text);

}  // namespace musclewarp
