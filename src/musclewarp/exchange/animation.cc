// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/animation.h"

#include <Eigen/LU>

namespace musclewarp {
namespace {

constexpr double kMetresPerMillimetre = 1e-3;

}  // namespace

Animation AnimationOf(const RunOutline& run, const std::vector<int>& frames) {
  Animation animation;
  animation.name = run.scene;
  animation.axes = run.axes;
  animation.names = run.names;
  animation.rest = ReadRestPose(run.rest, run.names);
  std::vector<std::string> folders;
  for (size_t i = 0; i < frames.size(); ++i) {
    const RecordedFrame& frame = run.frames[frames[i]];
    folders.push_back(frame.folder);
    animation.numbers.push_back(frame.figures.index);
    animation.times.push_back(
        run.has_times ? frame.figures.time - run.frames[frames[0]].figures.time
                      : static_cast<double>(i));
  }
  animation.read = [folders, names = run.names, rest = animation.rest](int i) {
    return ReadPose(folders[i], names, rest);
  };
  return animation;
}

GltfConversion GltfFromAxes(const std::string& axes) {
  GltfConversion conversion;
  conversion.gltf_from_axes.setZero();
  for (int k = 0; k < 3; ++k) {
    // Rows are the directions of glTF: left, superior, anterior.
    for (int row = 0; row < 3; ++row) {
      if (axes[k] == "LSA"[row]) conversion.gltf_from_axes(row, k) = 1;
      if (axes[k] == "RIP"[row]) conversion.gltf_from_axes(row, k) = -1;
    }
  }
  conversion.turns_triangles = conversion.gltf_from_axes.determinant() < 0;
  return conversion;
}

Points GltfConversion::Convert(const Points& points) const {
  return kMetresPerMillimetre * points * gltf_from_axes.transpose();
}

Triangles GltfConversion::Convert(const Triangles& triangles) const {
  Triangles converted = triangles;
  if (turns_triangles) converted.col(1).swap(converted.col(2));
  return converted;
}

Eigen::Matrix4d GltfConversion::Convert(const Eigen::Matrix4d& motion) const {
  Eigen::Matrix4d converted = Eigen::Matrix4d::Identity();
  converted.topLeftCorner<3, 3>() = gltf_from_axes *
                                    motion.topLeftCorner<3, 3>() *
                                    gltf_from_axes.transpose();
  converted.topRightCorner<3, 1>() =
      kMetresPerMillimetre * gltf_from_axes * motion.topRightCorner<3, 1>();
  return converted;
}

}  // namespace musclewarp
