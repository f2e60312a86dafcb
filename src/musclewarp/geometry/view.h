// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>

namespace musclewarp {

// The direction from which a picture is taken, in parallel projection. Both
// vectors are in the axes of the meshes, have unit length and are perpendicular
// to each other.
struct View {
  Eigen::Vector3d toward_viewer;
  Eigen::Vector3d up;  // points to the top of the picture
};

// Returns true if `axes` says how the axes of the meshes lie in the body, by
// the directions of +x, +y and +z with one letter each: L(eft), R(ight),
// A(nterior), P(osterior), S(uperior), I(nferior). The three must differ, as
// they do in "LPS", the axes of CT and MRI, and "ASR", those of OpenSim's
// ground and pelvis.
bool AreBodyAxes(const std::string& axes);

// Returns true if the axes make a right-handed frame, as body and image
// coordinates do. Precondition: AreBodyAxes(axes).
bool AreRightHanded(const std::string& axes);

// Returns the view of a name, which is one of the following:
// - anterior, posterior, left, right, superior or inferior: from that side;
// - lateral or medial: from the outer or inner side of a limb, whose `side` is
//   "left" or "right";
// - "x,y,z": from that direction, in the axes of the meshes, with superior at
//   the top of the picture;
// - "x,y,z;x,y,z": the same with the direction that is at the top.
//
// `axes` is as for AreBodyAxes. Throws InputError, which names the flag of the
// programs (--view, --axes or --side), if one of the three is not valid.
View ParseView(const std::string& name,
               const std::string& axes,
               const std::string& side);

}  // namespace musclewarp
