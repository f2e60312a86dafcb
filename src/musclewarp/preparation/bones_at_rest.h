// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// A bone in the rest pose, by reference.
struct BoneAtRest {
  const std::string& name;
  const std::string& body;
  const TriangleSoup& mesh;
};

// Two bones that cross each other as they were delivered. They stay as they
// are: bones are not moved, and the certificate does not count them.
struct BoneCrossing {
  std::string a, b;
  int triangle_pairs = 0;
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();  // middle of these, mm
};

// Returns the crossings of all bones, found by an exact test.
std::vector<BoneCrossing> BoneCrossings(const std::vector<BoneAtRest>& bones);

// Returns a sentence for every two bones that are near each other at rest, as
// in a joint, and that a pose takes apart by more than any joint moves: most
// often the centre of the joint is wrong, as where a bone is turned about the
// origin of an image. Computing such a pose takes long and comes to nothing. In
// a motion each pose is compared with the one before. Of each pair the largest
// move is named.
std::vector<std::string> BoneMoveWarnings(const Scene& scene,
                                          const std::vector<BoneAtRest>& bones);

}  // namespace musclewarp
