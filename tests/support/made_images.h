// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace musclewarp {

// A label image built in code.
struct MadeImage {
  Eigen::Array3i size = Eigen::Array3i::Zero();
  std::vector<unsigned char> labels;  // i runs fastest

  // The place of voxel (i, j, k, 1), mm, in LPS.
  Eigen::Matrix4d lps_from_index = Eigen::Matrix4d::Identity();
};

// Returns an image whose voxels have the label that `label` gives for the place
// of their centre, mm.
MadeImage MakeImage(const Eigen::Array3i& size,
                    const Eigen::Matrix4d& lps_from_index,
                    const std::function<int(const Eigen::Vector3d&)>& label);

// Returns the steps of voxels of the given edges (mm) along axes that are
// turned by 30 degrees about (1, 2, 3), with voxel (0, 0, 0) at `origin`.
Eigen::Matrix4d TurnedSteps(const Eigen::Vector3d& edges,
                            const Eigen::Vector3d& origin);

// Returns the volume of the voxels with a label, mm^3.
double VoxelVolumeOf(const MadeImage& image, int label);

// Returns the file of an image as NRRD, raw, with a "space", in which the steps
// are those of the image unless it is right-anterior-superior.
std::string NrrdBytes(const MadeImage& image,
                      const std::string& space = "left-posterior-superior");

// Returns the file of an image as .mha, uncompressed.
std::string MetaImageBytes(const MadeImage& image);

}  // namespace musclewarp
