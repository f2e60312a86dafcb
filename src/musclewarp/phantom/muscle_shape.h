// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "musclewarp/base/random_draws.h"

namespace musclewarp::phantom {

// The cross sections of a made-up muscle along its length, and how deep it is
// in its neighbours. All lengths are in mm. A place along the muscle is given
// by t, which is 0 at the origin and 1 at the insertion.
struct MuscleShape {
  // Half of the thickness in the middle and at the ends.
  double belly = 0;
  double tendon = 0;
  // The share of the length, at each end, in which the muscle is a tendon.
  double tendon_fraction = 0;
  // Half widths of a strap at the origin, in the middle, at the insertion.
  std::array<double, 3> width{};
  // How deep the muscle may be in bones and in other muscles.
  double depth_in_bones = 0;
  double depth_in_muscles = 0;

  // Returns true for a sheet, which needs more than one line.
  bool IsFlat() const { return width[1] > 1.5 * belly; }

  // Returns the mean of the thicknesses of belly and tendons.
  double MeanThickness() const { return belly + tendon; }

  double HalfThickness(double t) const;
  double HalfWidth(double t) const;
};

// Draws a shape: a round muscle, 4.4 to 40 mm thick, or in three of ten draws a
// flat one of 4 to 9 mm. `size` from 0 to 1 scales the largest thickness and
// width. Both depths are from 0.5 to 6 mm.
MuscleShape DrawMuscleShape(double size, RandomDraws* draws);

// Draws the edge length of the mesh of a muscle of this length, 1.5 to 5 mm.
// The diagonal of a cell is smaller than the thinnest part, and there are not
// many more than 4000 vertices unless that needs more.
double DrawCellSize(const MuscleShape& shape,
                    double length,
                    RandomDraws* draws);

}  // namespace musclewarp::phantom
