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

// The most voxels that an image may have: the labels take 4 bytes each in
// memory, beside what the file holds. 5e8 are 800 x 800 x 780.
constexpr std::int64_t kMostVoxels = 500000000;

// Where the voxels of an image are, as the header of its file says.
struct ImageGrid {
  Eigen::Array3i size = Eigen::Array3i::Zero();  // voxels along i, j and k

  // Takes the index (i, j, k, 1) of a voxel, counted from 0 in the order of the
  // file, to the place of its centre, mm. Its columns are the steps from voxel
  // to voxel, so that they hold the spacing and the direction of each axis.
  Eigen::Matrix4d world_from_index = Eigen::Matrix4d::Identity();

  // True if +x, +y and +z of that place are the left, the back and the head of
  // the patient (LPS), false if the file does not say where they point.
  bool is_oriented = false;

  // The names of labels, if the file has them, as .seg.nrrd does.
  std::map<int, std::string> names;

  std::int64_t NumVoxels() const;
  double VoxelVolume() const;  // mm^3
};

// Turns the axes of a grid in RAS (right, front, head, as in NIfTI) to LPS.
void TurnFromRas(ImageGrid* grid);

// Throws InputError, with `path` as its place, unless every axis has at least
// one voxel, there are at most kMostVoxels, the steps are 0.001 to 100 mm long
// and span a space, and the image is within 1e7 mm of the origin.
void CheckGrid(const std::string& path, const ImageGrid& grid);

// Throws InputError unless a file has at least `bytes` bytes of data from byte
// `begin` on.
void CheckDataSize(const std::string& path,
                   std::uint64_t begin,
                   std::uint64_t bytes);

// Returns the numbers in a text, between which there are blanks, commas and
// parentheses. Throws InputError with `where` as its place unless there are
// `count`, all finite.
std::vector<double> HeaderNumbers(const std::string& where,
                                  std::string_view text,
                                  std::size_t count);

// The same for the three sizes of an image, which are whole numbers.
Eigen::Array3i HeaderSizes(const std::string& where, std::string_view text);

}  // namespace musclewarp
