// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// The bodies and joints of an OpenSim model as MuJoCo has them. Lengths are in
// m and angles in rad, as in MuJoCo.

constexpr double kMetresPerMillimetre = 1 / kMillimetresPerMetre;

// A hinge or a slide. The joints of a body act one after the other, each in the
// frame that those before have moved.
struct MjcfJoint {
  std::string name;  // of the coordinate, if its value is that of one
  bool is_hinge = true;
  Eigen::Vector3d axis, anchor;  // in the frame of the body, all joints at 0
  std::optional<std::array<double, 2>> range;  // where the model clamps it
  double default_value = 0;
};

// A joint that follows another: its value is a polynomial of the other one.
// MuJoCo has these up to the fourth degree, OpenSim splines.
struct MjcfCoupling {
  std::string joint, of;  // `of` is empty for a constant
  std::array<double, 5> coefficients = {0, 0, 0, 0, 0};
  double largest_error = 0;  // over the range of the coordinate, rad or m
};

// A body that hangs on another one, or on the world.
struct MjcfBody {
  std::string name;
  int model_body = -1;  // in the model; -1 for one that has nothing but joints
  int parent = -1;      // in the list, or -1 for the world
  Eigen::Matrix4d parent_from_body = Eigen::Matrix4d::Identity();
  std::vector<MjcfJoint> joints;
};

struct MjcfTree {
  std::vector<MjcfBody> bodies;  // parents come first
  std::vector<MjcfCoupling> couplings;
  std::vector<std::string> notes;  // what could not be taken over, sentences
};

// Returns the tree of a model. Axes of joints that turn or move by a coordinate
// itself are joints with the name of the coordinate; others, and coordinates
// that the model couples or locks, follow by a MjcfCoupling, which is fitted
// over the range of the coordinate, or over `low` to `high` (rad or m, one for
// each coordinate) if these are wider. A coordinate that no axis has as it is
// becomes a joint of a small body of its own.
MjcfTree MakeMjcfTree(const Model& model,
                      const CoordinateValues& low,
                      const CoordinateValues& high);

}  // namespace musclewarp
