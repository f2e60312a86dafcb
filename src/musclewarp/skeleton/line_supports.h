// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Couples the points of a line of action to the same points of another line of
// the same muscle, which has as many.
struct LineTie {
  int other = -1;             // index of the other line, above the own
  Eigen::VectorXd stiffness;  // #P, 1/mm; 0 at the ends
};

// What holds the points of a taut line of action (taut_lines.h). Directions
// are those at rest, and turn with the bodies of the points. Forces are in
// units of the tension of the line, so that stiffnesses are in 1/mm.
struct LineSupports {
  // Each bend of the line at rest shows that something supports it there: a
  // bone, a retinaculum or another muscle. `bends` are the directions into
  // which the line would move without support (#P x 3, of unit length or zero),
  // `loads` the force that it bears (#P), and `stiffness` that of the support
  // (#P): zero where the line is straight.
  Points bends;
  Eigen::VectorXd loads;
  Eigen::VectorXd stiffness;

  // One-sided planes through the points at rest, which keep them from coming
  // nearer to their bones: outward directions (#P x 3) and stiffnesses (#P).
  Points outward;
  Eigen::VectorXd plane_stiffness;

  // The stiffness with which points along the attachments are held at their
  // places on the bodies, #P.
  Eigen::VectorXd hold;

  // A support is fully stiff when it is pressed by `onset`, a plane when it is
  // by `plane_onset`, mm: what lies between a line and its bone gets stiffer as
  // it is pressed.
  double onset = 0.5;
  double plane_onset = 50;

  std::vector<LineTie> ties;
};

// Scales all lengths: stiffnesses are forces by length.
void ScaleLengths(double factor, LineSupports* supports);

}  // namespace musclewarp
