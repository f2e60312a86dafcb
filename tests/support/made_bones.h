// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>

#include "musclewarp/joints/cylinder_fit.h"
#include "musclewarp/joints/femur_shape.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Plain bones made of balls, cylinders and tubes, whose joints are known. All
// have the axes of an image, x to the left of the body, y to the back, z up,
// and are in mm. `cell` is about the edge length of their meshes.

constexpr double kMadeHeadRadius = 23;
constexpr double kMadeCondyleRadius = 20;
constexpr double kMadeDomeRadius = 20;
constexpr double kMadeSocketRadius = 26;

// A femur. Its posterior condyles are two cylinders with one axis, each 30 mm
// long, with a notch of 15 mm between them.
struct MadeFemur {
  TriangleSoup surface;
  Eigen::Vector3d head;  // the centre of the head
  Axis knee;             // of the condyles, to the left; halfway between them
  Eigen::Vector3d up;    // the direction of the shaft
  Eigen::Vector3d back, left;
};

// A right femur, whose head lies to the left of its knee. The axis of its knee
// is neither level nor along x.
MadeFemur RightFemur(double cell);

// The mirror image, a left femur.
MadeFemur Mirrored(const MadeFemur& femur);

MadeFemur MovedBy(const Eigen::Isometry3d& motion, const MadeFemur& femur);

// Returns the directions of a made femur as its points (SampleSurface) show
// them.
BoneDirections DirectionsOf(const MadeFemur& femur,
                            const SurfacePoints& points);

// A talus with a dome 28 mm wide, and a tibia whose lower end is the matching
// hollow with a malleolus on one side, `gap` mm off.
struct MadeAnkle {
  TriangleSoup talus, tibia;
  Axis axis;  // of the dome, through the middle of it
};
MadeAnkle RightAnkle(double gap, double cell);

// A block with a hollow in its lower side, as a hip bone has its socket.
struct MadeSocket {
  TriangleSoup surface;
  Eigen::Vector3d center;
};
MadeSocket BlockWithSocket(double cell);

}  // namespace musclewarp
