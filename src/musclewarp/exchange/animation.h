// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "musclewarp/run/recorded_pose.h"
#include "musclewarp/run/run_reader.h"

namespace musclewarp {

// A run as programs for animation see it: the rest pose and what follows it.
struct Animation {
  std::string name;
  std::string axes;  // of the meshes, see AreBodyAxes in geometry/view.h
  RecordedNames names;
  RecordedPose rest;
  std::vector<int> numbers;   // of the frames in the run, rising
  std::vector<double> times;  // of the frames, s: from 0 on, rising

  // Reads a frame by its position in `times`. Frames are asked for in order,
  // each once, so that one at a time is in memory. May throw InputError.
  std::function<RecordedPose(int frame)> read;
};

// Returns the animation of some frames of a run, by their numbers in
// run.frames, rising. The first one is at time 0; frames without times follow
// each other after a second. Reads the rest pose. Throws InputError.
Animation AnimationOf(const RunOutline& run, const std::vector<int>& frames);

// How positions in the axes of the meshes, mm, become those of glTF: metres,
// +x to the left of the body, +y up, +z to its front.
struct GltfConversion {
  Eigen::Matrix3d gltf_from_axes;  // an orthogonal matrix of zeros and +-1

  // True if the axes of the meshes are left-handed: triangles are then turned
  // round, so that they still face outward.
  bool turns_triangles = false;

  Points Convert(const Points& points) const;  // mm to m
  Triangles Convert(const Triangles& triangles) const;

  // Returns a rigid motion in mm as one in m.
  Eigen::Matrix4d Convert(const Eigen::Matrix4d& motion) const;
};

// Returns the conversion. Precondition: AreBodyAxes(axes).
GltfConversion GltfFromAxes(const std::string& axes);

}  // namespace musclewarp
