// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>

#include "musclewarp/joints/joint_search.h"
#include "musclewarp/joints/surface_points.h"

namespace musclewarp {

struct Sphere {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  // mm
  double radius = 0;                                 // mm
};

// A sphere and how well a surface is one.
struct SphereFit {
  Sphere sphere;

  // The share of the sphere that the surface covers. 0.58 to 0.64 for the
  // whole head of a femur, up to 0.24 for the next best place of the bone.
  double coverage = 0;

  // Root mean square distance of the points from the sphere, mm, and their
  // number.
  double spread = 0;
  int points = 0;
};

// What FindSphere looks for.
struct SphereSearch {
  double min_radius = kJointSearch.head.least_head_radius;    // mm
  double max_radius = kJointSearch.head.largest_head_radius;  // mm

  // True for a socket, whose surface faces the centre of the sphere.
  bool is_hollow = false;
};

// Finds the sphere of which a surface covers the largest share. For a radius r
// every point p with normal n votes for the centre p - r n (p + r n for a
// socket). The places with the most votes start a robust least squares fit
// (FitSphere) to the points that lie near the sphere and face away from its
// centre. Neither the orientation of the bone nor the rest of its shape
// matters. Nothing is returned if no radius has a single place with votes that
// a fit confirms.
//
// Sources: votes as in Hough transforms of oriented points; heads of femora by
// spheres, Renault et al. 2018, doi 10.1016/j.jbiomech.2018.08.028.
std::optional<SphereFit> FindSphere(const SurfacePoints& surface,
                                    const SphereSearch& search);

// Fits a sphere to all points (#P x 3, mm) by minimising the sum of
// rho(|p - c| - r), where rho is quadratic below `scale` (mm) and linear beyond
// it (soft L1), starting at `start`. Precondition (CHECKed): there are at least
// four points; if they are in a plane, the result is one of many.
Sphere FitSphere(const Points& points, const Sphere& start, double scale);

}  // namespace musclewarp
