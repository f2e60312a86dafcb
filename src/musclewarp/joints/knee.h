// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "musclewarp/joints/cylinder_fit.h"
#include "musclewarp/joints/femur_shape.h"

namespace musclewarp {

// The cylinder on the posterior condyles of a femur.
struct KneeFit {
  // The axis points to the left of the body; its point is halfway between the
  // middles of both condyles.
  Cylinder cylinder;

  // The angle about the axis that each condyle covers, rad; left and right as
  // the axis has it.
  double left_angle = 0, right_angle = 0;

  double spread = 0;  // root mean square distance from the cylinder, mm
  int points = 0;     // on the condyle that has fewer

  // The angle between the axis and the line through the centres of spheres
  // fitted to both condyles, rad.
  double sphere_angle = 0;
};

// Finds the axis of a knee: one cylinder for both posterior condyles (Kai et
// al. 2014, doi 10.1016/j.jbiomech.2013.12.013; Renault et al. 2018, doi
// 10.1016/j.jbiomech.2018.08.028). Circles are voted for in several directions
// about left and right, from the points of both condyles alike; the best start
// fits of cylinders, of which the one with the most surface on both condyles is
// taken. Nothing is returned if no fit has points on both.
//
// `directions` are those of the femur, as they are or as an image gives them;
// `head_radius` (mm) is that of its head, or 23 if it is not known.
std::optional<KneeFit> FitKnee(const SurfacePoints& femur,
                               const BoneDirections& directions,
                               double head_radius);

}  // namespace musclewarp
