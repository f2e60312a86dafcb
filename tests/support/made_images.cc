// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "support/made_images.h"

#include <Eigen/Dense>
#include <cmath>
#include <sstream>

namespace musclewarp {
namespace {

// "a b c" of a column of a matrix, with all digits.
std::string ColumnText(const Eigen::Matrix4d& matrix,
                       int column,
                       const char* between) {
  std::ostringstream text;
  text.precision(17);
  text << matrix(0, column) << between << matrix(1, column) << between
       << matrix(2, column);
  return text.str();
}

std::string LabelBytes(const MadeImage& image) {
  return std::string(image.labels.begin(), image.labels.end());
}

}  // namespace

MadeImage MakeImage(const Eigen::Array3i& size,
                    const Eigen::Matrix4d& lps_from_index,
                    const std::function<int(const Eigen::Vector3d&)>& label) {
  MadeImage image;
  image.size = size;
  image.lps_from_index = lps_from_index;
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        const Eigen::Vector4d place =
            lps_from_index * Eigen::Vector4d(i, j, k, 1);
        image.labels.push_back(
            static_cast<unsigned char>(label(place.head<3>())));
      }
    }
  }
  return image;
}

Eigen::Matrix4d TurnedSteps(const Eigen::Vector3d& edges,
                            const Eigen::Vector3d& origin) {
  Eigen::Matrix4d steps = Eigen::Matrix4d::Identity();
  steps.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(M_PI / 6, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix() *
      edges.asDiagonal();
  steps.topRightCorner<3, 1>() = origin;
  return steps;
}

double VoxelVolumeOf(const MadeImage& image, int label) {
  double count = 0;
  for (const unsigned char value : image.labels) count += value == label;
  return count *
         std::abs(image.lps_from_index.topLeftCorner<3, 3>().determinant());
}

std::string NrrdBytes(const MadeImage& image, const std::string& space) {
  Eigen::Matrix4d steps = image.lps_from_index;
  if (space == "right-anterior-superior") steps.topRows<2>() *= -1;
  std::ostringstream text;
  text << "NRRD0004\n# made in a test\ntype: unsigned char\ndimension: 3\n"
       << (space.empty() ? "" : "space: " + space + "\n")
       << "sizes: " << image.size.transpose() << "\nspace directions:";
  for (int axis = 0; axis < 3; ++axis) {
    text << " (" << ColumnText(steps, axis, ",") << ")";
  }
  text << "\nkinds: domain domain domain\nencoding: raw\nspace origin: ("
       << ColumnText(steps, 3, ",") << ")\n\n"
       << LabelBytes(image);
  return text.str();
}

std::string MetaImageBytes(const MadeImage& image) {
  std::ostringstream text, matrix, spacing;
  matrix.precision(17);
  spacing.precision(17);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d step = image.lps_from_index.col(axis).head<3>();
    matrix << " " << step.normalized().transpose();
    spacing << " " << step.norm();
  }
  text << "ObjectType = Image\nNDims = 3\nBinaryData = True\n"
       << "BinaryDataByteOrderMSB = False\nCompressedData = False\n"
       << "TransformMatrix =" << matrix.str()
       << "\nOffset = " << ColumnText(image.lps_from_index, 3, " ")
       << "\nCenterOfRotation = 0 0 0\nElementSpacing =" << spacing.str()
       << "\nDimSize = " << image.size.transpose()
       << "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n"
       << LabelBytes(image);
  return text.str();
}

}  // namespace musclewarp
