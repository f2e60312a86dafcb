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

// Triangle f of mesh a and triangle g of mesh b, which cross.
struct CrossingTriangle {
  int a, f;
  int b, g;
};

// What is wrong with the vertices that a relaxation has found: where, not only
// how much.
struct Defects {
  std::vector<CrossingTriangle> muscle_crossings;  // of muscles a < b
  std::vector<CrossingTriangle> bone_crossings;    // of muscle a and bone b

  // Of muscle a with itself (b == a). Those that a plane can separate: the two
  // were apart before the step or are apart where the coarse mesh has them.
  std::vector<CrossingTriangle> self_crossings;

  // By muscle: triangles that folded since the rest pose, if the muscle has
  // more of them than DefectOptions::max_folded_fraction.
  std::vector<std::vector<FoldedTriangle>> folded;

  // Pairs of triangles of two meshes that cross.
  int num_crossings() const;
  int num_folded() const;

  // True if triangles cross each other.
  bool HasCrossings() const {
    return num_crossings() + self_crossings.size() > 0;
  }
};

// Finds what is wrong with `points` (#V x 3 each, mm), by exact tests. `trees`
// are over the triangles of the muscles and are fitted to other places here.
Defects FindDefects(const StepOptions& options,
                    const ContactStep& step,
                    const std::vector<Points>& targets,
                    const std::vector<Points>& points,
                    std::vector<TriangleBvh>* trees);

// Returns planes that separate the triangles again: those of two meshes, and of
// one muscle, as they were separated before the step or, of one muscle, as they
// are where the coarse mesh has them. A folded triangle gets a plane through
// its longest edge that its third corner has to stay above, in the direction
// that it would have if it had turned with its surroundings.
std::vector<SeparatingPlane> PlanesAgainst(const Defects& defects,
                                           const StepOptions& options,
                                           const ContactStep& step,
                                           const std::vector<Points>& targets);

// Returns the stiffness for the next round: triangles of one muscle that cross
// each other or fold move more as one piece, as it is small moves of single
// vertices that make small triangles do so.
Stiffness Stiffened(const Defects& defects,
                    const DefectOptions& options,
                    const ContactScene& scene,
                    Stiffness stiffness);

}  // namespace musclewarp
