// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Options of the contact of Kellnhofer and Kohout (paper section 3).
struct PaperContactOptions {
  // The share of its way to the surface of the other body that a vertex goes if
  // the other body is a muscle, which goes its own share. It is more than half,
  // because half is too little for some shapes (paper fig. 3.4). The way to the
  // surface of an obstacle is gone in full.
  double deformable_fraction = 0.6;

  // Regions are paired if their centres are at most this far apart, as a share
  // of the smaller of the two bounding spheres' radii (paper section 3.2). The
  // final fix pushes no triangle farther than this share.
  double pairing_fraction = 0.1;

  // Beyond the paper: the distance beyond the surface at which a vertex is put,
  // mm, so that it is outside by more than rounding.
  double clearance = 0.02;

  // Seed of the directions of the rays that tell inside from outside.
  unsigned seed = 1;

  // Returns false and names the field, its value and the rule if a field is out
  // of range.
  bool IsValid(std::string* error) const;
};

}  // namespace musclewarp
