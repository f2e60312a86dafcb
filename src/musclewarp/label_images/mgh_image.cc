// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/label_images/mgh_image.h"

#include <Eigen/Core>

#include "musclewarp/base/input_error.h"
#include "musclewarp/label_images/unpacked_file.h"
#include "musclewarp/mesh_files/export_advice.h"

namespace musclewarp {
namespace {

constexpr std::size_t kHeaderBytes = 284;

// The offsets of numbers in the header, in bytes.
constexpr int kVersion = 0, kSizes = 4, kFrames = 16, kType = 20;
constexpr int kHasFrame = 28, kSpacing = 30, kDirections = 42, kCentre = 78;

// Reads numbers in the header.
class MghHeader {
 public:
  explicit MghHeader(const std::string& bytes) : bytes_(bytes) {}

  template <typename T>
  T At(int place, int index = 0) const {
    return LoadAs<T>(
        bytes_.data() + place + index * static_cast<int>(sizeof(T)),
        ByteOrder::kBig);
  }
  Eigen::Vector3d VectorAt(int place, int index = 0) const {
    Eigen::Vector3d vector;
    for (int i = 0; i < 3; ++i) vector[i] = At<float>(place, 3 * index + i);
    return vector;
  }

 private:
  const std::string& bytes_;
};

ScalarType TypeOf(const std::string& path, int type) {
  switch (type) {
    case 0:
      return ScalarType::kUInt8;
    case 1:
      return ScalarType::kInt32;
    case 3:
      return ScalarType::kFloat32;
    case 4:
      return ScalarType::kInt16;
    case 10:
      return ScalarType::kUInt16;
    default:
      throw InputError(path,
                       "has voxels of type " + std::to_string(type) +
                           "; allowed: 0 (uchar), 1 (int), 3 (float), 4 "
                           "(short), 10 (ushort)",
                       "convert it by mri_convert to whole numbers (int)");
  }
}

// Returns the grid. The centre in FreeSurfer is the centre of voxel (size / 2),
// which for even sizes is half a voxel beyond the middle.
ImageGrid GridOf(const MghHeader& header) {
  ImageGrid grid;
  for (int axis = 0; axis < 3; ++axis) {
    grid.size[axis] = header.At<std::int32_t>(kSizes, axis);
  }
  Eigen::Matrix3d steps;
  steps << -1, 0, 0, 0, 0, 1, 0, -1, 0;  // coronal, in RAS
  Eigen::Vector3d centre(0, 0, 0);
  const bool has_frame = header.At<std::int16_t>(kHasFrame) > 0;
  if (has_frame) {
    for (int axis = 0; axis < 3; ++axis) {
      steps.col(axis) =
          header.At<float>(kSpacing, axis) * header.VectorAt(kDirections, axis);
    }
    centre = header.VectorAt(kCentre);
  }
  grid.world_from_index.topLeftCorner<3, 3>() = steps;
  grid.world_from_index.col(3).head<3>() =
      centre - steps * (grid.size.cast<double>() / 2).matrix();
  TurnFromRas(&grid);
  grid.is_oriented = has_frame;
  return grid;
}

}  // namespace

MghImage ReadMghImage(const std::string& path) {
  const std::string start = ReadUnpacked(path, kHeaderBytes);
  const MghHeader header(start);
  // The higher bytes of the version state the intent of the image.
  constexpr int kVersionMask = 0xff;
  if (start.size() < kHeaderBytes ||
      (header.At<std::int32_t>(kVersion) & kVersionMask) != 1) {
    throw InputError(path,
                     "is no image of FreeSurfer: it does not start with the "
                     "number 1 and a header of 284 bytes",
                     "name the file by what it holds, or copy it again");
  }
  const auto frames = header.At<std::int32_t>(kFrames);
  if (frames != 1) {
    throw InputError(path,
                     "has " + std::to_string(frames) +
                         " points of time; allowed: one number a voxel",
                     "export one label map");
  }
  MghImage image;
  image.type = TypeOf(path, header.At<std::int32_t>(kType));
  image.grid = GridOf(header);
  CheckGrid(path, image.grid);
  const auto needed =
      static_cast<std::uint64_t>(image.grid.NumVoxels()) * SizeOf(image.type);
  image.bytes = ReadUnpacked(path, kHeaderBytes + needed).substr(kHeaderBytes);
  if (image.bytes.size() < needed) {
    throw InputError(
        path,
        "is truncated: it has " + std::to_string(image.bytes.size()) +
            " bytes of voxels, its header promises " + std::to_string(needed),
        kCopyAgain);
  }
  return image;
}

}  // namespace musclewarp
