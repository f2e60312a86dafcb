// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/image_grid.h"

#include <Eigen/Dense>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "musclewarp/base/input_error.h"
#include "musclewarp/mesh_files/export_advice.h"
#include "musclewarp/mesh_files/text_cursor.h"

namespace musclewarp {
namespace {

constexpr double kShortestStep = 1e-3, kLongestStep = 100;  // mm
constexpr double kFarthestVoxel = 1e7;  // mm, as for the points of meshes

// The smallest sine of the angle between steps that span a space.
constexpr double kLeastSpan = 1e-3;

std::string SizeText(const ImageGrid& grid) {
  std::ostringstream text;
  text << grid.size[0] << " x " << grid.size[1] << " x " << grid.size[2];
  return text.str();
}

}  // namespace

std::int64_t ImageGrid::NumVoxels() const {
  return size.cast<std::int64_t>().prod();
}

double ImageGrid::VoxelVolume() const {
  return std::abs(world_from_index.topLeftCorner<3, 3>().determinant());
}

void TurnFromRas(ImageGrid* grid) {
  grid->world_from_index.topRows<2>() *= -1;
  grid->is_oriented = true;
}

void CheckGrid(const std::string& path, const ImageGrid& grid) {
  if (grid.size.minCoeff() < 1) {
    throw InputError(path,
                     "has " + SizeText(grid) +
                         " voxels; allowed: at least 1 "
                         "along each axis",
                     kCopyAgain);
  }
  // The product of doubles does not overflow.
  if (grid.size.cast<double>().prod() > static_cast<double>(kMostVoxels)) {
    throw InputError(
        path,
        "has " + SizeText(grid) + " voxels; allowed: at most 5e8 in all",
        "crop the image to the muscles and bones, or resample it");
  }
  const Eigen::Matrix3d steps = grid.world_from_index.topLeftCorner<3, 3>();
  for (int axis = 0; axis < 3; ++axis) {
    const double step = steps.col(axis).norm();
    if (step >= kShortestStep && step <= kLongestStep) continue;
    std::ostringstream text;
    text << "its voxels are " << step << " mm apart along axis " << axis
         << "; allowed: 0.001 to 100 mm";
    throw InputError(
        path, text.str(), "check the spacing and the units of the image");
  }
  const Eigen::Matrix3d directions = steps.colwise().normalized();
  if (!(std::abs(directions.determinant()) >= kLeastSpan)) {
    throw InputError(
        path, "the directions of its axes lie in a plane", kCopyAgain);
  }
  const Eigen::Vector4d last(
      grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1, 1);
  const bool is_near =
      grid.world_from_index.allFinite() &&
      grid.world_from_index.col(3).head<3>().cwiseAbs().maxCoeff() <=
          kFarthestVoxel &&
      (grid.world_from_index * last).head<3>().cwiseAbs().maxCoeff() <=
          kFarthestVoxel;
  if (!is_near) {
    throw InputError(path,
                     "its voxels are farther than 1e7 mm from the origin",
                     "check the origin and the units of the image");
  }
}

void CheckDataSize(const std::string& path,
                   std::uint64_t begin,
                   std::uint64_t bytes) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size >= begin && size - begin >= bytes) return;
  const std::uintmax_t there = error || size < begin ? 0 : size - begin;
  throw InputError(path,
                   "is truncated: it has " + std::to_string(there) +
                       " bytes of voxels, its header promises " +
                       std::to_string(bytes),
                   kCopyAgain);
}

std::vector<double> HeaderNumbers(const std::string& where,
                                  std::string_view text,
                                  std::size_t count) {
  constexpr std::string_view kBetween = " \t\r,()";
  std::vector<double> numbers;
  std::size_t begin = 0;
  while ((begin = text.find_first_not_of(kBetween, begin)) !=
         std::string_view::npos) {
    std::size_t end = text.find_first_of(kBetween, begin);
    if (end == std::string_view::npos) end = text.size();
    const std::string_view word = text.substr(begin, end - begin);
    double number = 0;
    const auto [rest, error] =
        std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || rest != word.data() + word.size() ||
        !std::isfinite(number)) {
      throw InputError(
          where, "has " + Quoted(word) + ", which is no number", kCopyAgain);
    }
    numbers.push_back(number);
    begin = end;
  }
  if (numbers.size() != count) {
    throw InputError(where,
                     "has " + std::to_string(numbers.size()) + " numbers; " +
                         std::to_string(count) + " are expected",
                     kCopyAgain);
  }
  return numbers;
}

Eigen::Array3i HeaderSizes(const std::string& where, std::string_view text) {
  const std::vector<double> numbers = HeaderNumbers(where, text, 3);
  Eigen::Array3i size;
  for (int axis = 0; axis < 3; ++axis) {
    const double number = numbers[axis];
    if (number != std::floor(number) || number < 1 || number > 1e9) {
      throw InputError(
          where,
          "is " + Quoted(text) + "; allowed: whole numbers above 0",
          kCopyAgain);
    }
    size[axis] = static_cast<int>(number);
  }
  return size;
}

}  // namespace musclewarp
