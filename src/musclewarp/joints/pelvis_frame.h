// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "musclewarp/anatomy/bone.h"
#include "musclewarp/joints/sphere_fit.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Returns the axes of a pelvis, in columns: x forward, y up, z to the right.
// The plane of y and z is that of both front iliac spines and the pubis, which
// are the corners of the largest triangle of the convex hull of both hip bones
// (Modenese and Renault 2021, doi 10.1016/j.jbiomech.2020.110186); z is along
// the spines. If the second largest triangle is within 5 % of the largest, the
// one with its long side nearer to `across` is taken, the line through the
// centres of the hips if it is known, or zero.
//
// `points` (#P x 3, mm) are those of both hip bones; a sacrum among them does
// not matter as long as it is behind. Nothing is returned if the points are in
// a plane.
std::optional<Eigen::Matrix3d> PelvisAxes(const Points& points,
                                          const Eigen::Vector3d& across);

// Returns true if a mesh that is called a pelvis is one hip bone: the centre of
// the head of a femur, which lies to one side of a whole pelvis, is then too
// near to the middle of the mesh. `points`: #P x 3, mm, evenly over its
// surface.
bool IsOneHipBone(const Points& points, const Sphere& femoral_head);

// Returns the points of a hip bone and those of its mirror image, which stands
// in for the other one: the mirror is at right angles to `right`, the right of
// the body, and touches the bone where it reaches farthest to the other side,
// at the pubic symphysis.
Points WithMirrorImage(const Points& hip_bone,
                       Side side,
                       const Eigen::Vector3d& right);

}  // namespace musclewarp
