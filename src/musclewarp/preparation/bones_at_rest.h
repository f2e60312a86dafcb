// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// A bone in the rest pose, by reference.
struct BoneAtRest {
  const std::string& name;
  const std::string& body;
  const SearchableMesh& mesh;
};

// Two bones that cross each other as delivered. Bones are rigid, so the
// crossing remains, and the certificate does not count it.
struct BoneCrossing {
  std::string a, b;
  int triangle_pairs = 0;
  Eigen::RowVector3d place = Eigen::RowVector3d::Zero();  // their centre, mm
};

// Returns the crossings of all bones, found by an exact test.
std::vector<BoneCrossing> BoneCrossings(const std::vector<BoneAtRest>& bones);

// Returns a warning for each pair of bones that are close at rest, as in a
// joint, and that a pose moves apart by more than any joint allows. The usual
// cause is a wrong joint centre, as with a rotation about the origin of an
// image. Computing such a pose takes long and fails. Each pose is compared with
// the one from which it is reached (PoseBefore). The warning states the largest
// move of the pair.
std::vector<std::string> BoneMoveWarnings(const Scene& scene,
                                          const std::vector<BoneAtRest>& bones);

}  // namespace musclewarp
