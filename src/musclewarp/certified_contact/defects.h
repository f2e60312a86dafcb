// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/relaxation.h"
#include "musclewarp/certified_contact/separating_planes.h"
#include "musclewarp/certified_contact/step_options.h"
#include "musclewarp/geometry/folded_triangles.h"

namespace musclewarp {

// Two crossing triangles: triangle f of mesh a and triangle g of mesh b.
struct CrossingTriangle {
  int a, f;
  int b, g;
};

// The defects of a relaxed state, triangle by triangle, so that the next round
// can repair them. DefectCounts has their numbers.
struct Defects {
  std::vector<CrossingTriangle> muscle_crossings;  // of muscles a < b
  std::vector<CrossingTriangle> bone_crossings;    // of muscle a and bone b

  // Of muscle a with itself (b == a). Includes only pairs that a plane can
  // separate: those apart before the step or at the targets.
  std::vector<CrossingTriangle> self_crossings;

  // By muscle: triangles folded relative to the rest pose, if they exceed
  // DefectOptions::max_folded_fraction.
  std::vector<std::vector<FoldedTriangle>> folded;

  // The number of crossing pairs of triangles of two meshes.
  int num_crossings() const;
  int num_folded() const;

  // True if any triangles cross, self-crossings included.
  bool HasCrossings() const {
    return num_crossings() + self_crossings.size() > 0;
  }
};

// Finds the defects of `points` (#V x 3 each, mm), crossings by exact tests.
// `targets`: #V x 3 each, mm. `trees`: over the triangles of the muscles;
// refitted by this function.
Defects FindDefects(const StepOptions& options,
                    const ContactStep& step,
                    const std::vector<Points>& targets,
                    const std::vector<Points>& points,
                    std::vector<TriangleBvh>* trees);

// Returns planes against the defects. Crossing triangles are separated as
// before the step or, within one muscle, as at `targets`. A folded triangle
// gets a plane through its longest edge that keeps its third corner on the
// unfolded side, given by the rotation of the surrounding surface.
std::vector<SeparatingPlane> PlanesAgainst(const Defects& defects,
                                           const StepOptions& options,
                                           const ContactStep& step,
                                           const std::vector<Points>& targets);

// Returns the stiffness for the next round, larger at folded and self-crossing
// triangles: independent small moves of single vertices cause these defects in
// small triangles, and a stiffer neighbourhood moves as one piece.
Stiffness Stiffened(const Defects& defects,
                    const DefectOptions& options,
                    const ContactScene& scene,
                    Stiffness stiffness);

}  // namespace musclewarp
