// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

struct PaperContactOptions {
  // How far a vertex goes of its way to the other's surface if the other can
  // give way too. More than half, as half is too little for some shapes (paper
  // fig. 3.4). Against an obstacle it goes all the way.
  double deformable_share = 0.6;

  // Regions are paired up to this distance of their centres, as a share of the
  // smaller of the two bounding spheres' radii. In the final fix, no triangle
  // is pushed farther.
  double pairing_share = 0.1;

  // Beyond the paper: how far beyond the surface a vertex is put, mm, so that
  // it is outside by more than rounding.
  double clearance = 0.02;

  // Of the directions of the rays that tell inside from outside.
  unsigned seed = 1;

  bool IsValid(std::string* error) const;
};

}  // namespace musclewarp
