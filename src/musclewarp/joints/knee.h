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
// 10.1016/j.jbiomech.2018.08.028). The points of both condyles vote for circles
// in planes across several directions close to left-right. The best circles
// start cylinder fits. Returns the fit with the most surface on both condyles,
// or nothing if no fit has points on both.
//
// `directions` are those of the femur, from its shape or from the image;
// `head_radius` (mm) is the radius of its head, or the usual one if it has
// none.
std::optional<KneeFit> FitKnee(const SurfacePoints& femur,
                               const BoneDirections& directions,
                               double head_radius);

}  // namespace musclewarp
