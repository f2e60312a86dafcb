// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/bone_trees.h"

#include "musclewarp/base/parallel_for.h"
#include "musclewarp/mesh/triangle_difference.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

BoneTrees::BoneTrees(const TriangleSoup& rest)
    : mesh(rest), clusters(rest.points, rest.triangles) {}

void AddBoneTrees(std::vector<PreparedBone>* bones) {
  ParallelFor(bones->size(),
              [&](size_t i) { (*bones)[i].trees = TreesOf((*bones)[i]); });
}

std::shared_ptr<const BoneTrees> TreesOf(const PreparedBone& bone) {
  if (bone.trees && AreSame(bone.trees->mesh.soup(), bone.rest)) {
    return bone.trees;
  }
  return std::make_shared<BoneTrees>(bone.rest);
}

}  // namespace musclewarp
