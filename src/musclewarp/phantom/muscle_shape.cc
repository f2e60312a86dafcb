// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/muscle_shape.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/phantom/field.h"

namespace musclewarp::phantom {

double MuscleShape::HalfThickness(double t) const {
  constexpr double kRise = 0.3;  // the share in which a tendon becomes belly
  return tendon + (belly - tendon) * SmoothStep(tendon_fraction,
                                                tendon_fraction + kRise,
                                                std::min(t, 1 - t));
}

double MuscleShape::HalfWidth(double t) const {
  return t < 0.5 ? width[0] + (width[1] - width[0]) * SmoothStep(0, 0.5, t)
                 : width[1] + (width[2] - width[1]) * SmoothStep(0.5, 1, t);
}

MuscleShape DrawMuscleShape(double size, RandomDraws* draws) {
  MuscleShape shape;
  if (draws->Chance(0.3)) {
    shape.belly = draws->Uniform(2, 2.5 + 2 * size);
    shape.tendon = draws->Uniform(2, shape.belly);
    const double widest = 10 + 30 * size;
    for (double& width : shape.width) width = draws->Uniform(8, widest);
  } else {
    shape.belly = draws->Uniform(3.5, 6 + 14 * size);
    shape.tendon = draws->Uniform(2.2, std::min(6.0, shape.belly));
    for (double& width : shape.width) width = draws->Uniform(0, shape.tendon);
    shape.width[1] = draws->Uniform(0, 0.5) * shape.belly;
    if (draws->Chance(0.4)) shape.tendon_fraction = draws->Uniform(0.1, 0.2);
  }
  shape.depth_in_bones = draws->Uniform(0.5, 6);
  shape.depth_in_muscles = draws->Uniform(0.5, 6);
  return shape;
}

double DrawCellSize(const MuscleShape& shape,
                    double length,
                    RandomDraws* draws) {
  constexpr double kMostVertices = 4000;
  constexpr double kPi = 3.14159265358979323846;
  const double girth = 2 * kPi * shape.belly + 4 * shape.width[1];
  // 1.8 is a little more than the diagonal of a unit cell.
  const double coarsest = std::min(5.0, 2 * shape.tendon / 1.8);
  const double finest =
      std::max(1.5, std::sqrt(girth * length / kMostVertices));
  return draws->Uniform(std::min(finest, coarsest), coarsest);
}

}  // namespace musclewarp::phantom
