// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/base/random_draws.h"
#include "musclewarp/phantom/field.h"
#include "musclewarp/phantom/random_bones.h"
#include "musclewarp/phantom/strap.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp::phantom {

// An end of a muscle: the bone that it is attached to (an index), the point of
// its surface and the outward normal there.
struct MuscleEnd {
  int bone = 0;
  Eigen::Vector3d site;
  Eigen::Vector3d normal;
};

// A muscle of a random scene, 40 to 300 mm long and 4 to 40 mm thick.
struct RandomMuscle {
  std::string name;
  // Origin and insertion.
  std::array<MuscleEnd, 2> ends;
  // The muscle before it is cut where it would be too deep in bones and other
  // muscles; later muscles keep out of it.
  Field strap;
  Eigen::AlignedBox3d box;
  // The mean of belly and tendons, mm.
  double thickness = 0;
  PhantomMesh mesh;
  // One line through the middle, and for a wide muscle one more on each side.
  std::vector<ActionLine> lines;
};

// Draws a muscle from one bone to another. It may be round or flat, with or
// without tendons, run beside an earlier muscle and share its areas of
// attachment, wrap around a bone or lie between two bones. It is up to 6 mm
// deep in bones, and up to 6 mm in each earlier muscle; both depths are drawn,
// and are at most a third of the thickness of the thinner of the two.
//
// `size` from 0 to 1 scales the largest thickness and width; small values find
// room where others do not.
//
// Returns nothing if what was drawn is not sound: if there is no room, if the
// mesh is not a sphere without self-crossings, or if less than 60 % of its
// volume is outside bones.
std::optional<RandomMuscle> DrawMuscle(const std::string& name,
                                       const std::vector<RandomBone>& bones,
                                       const std::vector<RandomMuscle>& earlier,
                                       double size,
                                       RandomDraws* draws);

}  // namespace musclewarp::phantom
