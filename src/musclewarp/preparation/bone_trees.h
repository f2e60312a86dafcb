// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "musclewarp/certificate/triangle_clusters.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {

struct PreparedBone;

// What finds the triangles of a bone in the rest pose. Making it takes longer
// than most searches, so that all searches in a scene share it.
struct BoneTrees {
  explicit BoneTrees(const TriangleSoup& rest);

  SearchableMesh mesh;
  TriangleClusters clusters;
};

// Makes the trees of bones. `bones` may have some already.
void AddBoneTrees(std::vector<PreparedBone>* bones);

// Returns the trees of a bone: those that it has or, if its mesh has been
// changed since, new ones.
std::shared_ptr<const BoneTrees> TreesOf(const PreparedBone& bone);

}  // namespace musclewarp
