// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certified_contact/step.h"
#include "support/meshes.h"

namespace musclewarp {

// Muscles and bones for tests of contact, at rest at first.
struct ContactGroup {
  std::vector<TriangleSoup> soups, bone_soups;
  ContactScene scene;
  ContactState state;

  ContactGroup(std::vector<TriangleSoup> muscles,
               std::vector<TriangleSoup> bones);

  // Moves on to the targets and places of a state, the points of which do not
  // matter. If nothing crosses there, that becomes the state.
  StepSummary StepTo(const ContactState& next, const StepOptions& options = {});

  // Pairs of triangles of two meshes that cross in the state.
  int CrossingPairs() const;

  // Relative, in the state.
  double VolumeError(size_t muscle) const;
};

// Returns the planes between muscles and those of bones, found anew.
std::vector<SeparatingPlane> AllPlanes(const StepOptions& options,
                                       const ContactStep& step);

// A sphere over a bone, half a millimetre above it, and one beside the sphere.
ContactGroup SpheresOverABone();

}  // namespace musclewarp
