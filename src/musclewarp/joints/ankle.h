// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "musclewarp/joints/cylinder_fit.h"
#include "musclewarp/joints/sphere_fit.h"

namespace musclewarp {

// The cylinder on the dome of a talus.
struct AnkleFit {
  // Its point is at the middle of the dome.
  Cylinder cylinder;
  double angle = 0;   // about the axis that the dome covers, rad
  double spread = 0;  // root mean square distance from the cylinder, mm
  int points = 0;
};

// Finds the axis of an ankle: fits a cylinder to the dome of the talus, the
// part of it that faces the tibia, from starts in several directions. Returns
// the fit with the most points, extended to the whole dome, or nothing if the
// talus does not face the tibia.
std::optional<AnkleFit> FitAnkle(const SurfacePoints& talus,
                                 const SurfacePoints& tibia);

// The two spheres of a talus. The foot turns about the line through their
// centres.
struct SubtalarFit {
  SphereFit head;         // looks at the navicular
  SphereFit facet;        // hollow, looks at the heel bone
  double facet_area = 0;  // mm^2
  Axis axis;              // its point is halfway between the centres
};

// Finds the axis of a subtalar joint (Modenese and Renault 2021, doi
// 10.1016/j.jbiomech.2020.110186). `foot` may be one mesh of all bones below
// and before the talus, or the heel bone with the navicular. Nothing is
// returned if either sphere is not found.
std::optional<SubtalarFit> FitSubtalar(const SurfacePoints& talus,
                                       const SurfacePoints& foot);

}  // namespace musclewarp
