// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

namespace musclewarp {

// Where a picture is taken from, parallel projection. Both are unit vectors
// and perpendicular.
struct View {
  Eigen::Vector3d toward_viewer;
  Eigen::Vector3d up;
};

// How the axes of the meshes lie in the body: for +x, +y, +z one letter each,
// L(eft) R(ight) A(nterior) P(osterior) S(uperior) I(nferior). CT and MRI come
// as "LPS", OpenSim's ground and pelvis are "ASR".
//
// True if that names three different directions, as "LPS" does.
bool AreBodyAxes(const std::string& axes);

// name: anterior, posterior, left, right, superior, inferior, as seen from
// there; lateral and medial for a limb of `side` ("left" or "right");
// or a direction "x,y,z" towards the viewer in the axes of the meshes, with an
// optional upward direction "x,y,z;x,y,z" (default: superior).
// Throws InputError that names the flag (--view, --axes, --side).
View ParseView(const std::string& name,
               const std::string& axes,
               const std::string& side);

}  // namespace musclewarp
