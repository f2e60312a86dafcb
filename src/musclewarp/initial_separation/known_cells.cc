// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/known_cells.h"

#include <algorithm>
#include <atomic>
#include <deque>

#include "musclewarp/mesh/triangle_difference.h"

namespace musclewarp {
namespace {

// Returns true if boxes of triangles of two meshes come within `reach` of each
// other, or if one mesh lies inside the other.
bool AreNear(const SearchableMesh& a, const SearchableMesh& b, double reach) {
  if (a.bvh().num_triangles() == 0 || b.bvh().num_triangles() == 0) {
    return false;
  }
  std::atomic<bool> is_near = false;
  const auto enter = [&](int of_a, int of_b) {
    return !is_near && a.bvh().node_box(of_a).SquaredDistance(
                           b.bvh().node_box(of_b)) <= reach * reach;
  };
  a.bvh().CollectPairs(b.bvh(), enter, [&](int, int) {
    is_near = true;
    return false;
  });
  // Surfaces that are apart contain each other with a vertex or not at all.
  return is_near || b.winding().IsInside(a.bvh().corners(0).row(0)) ||
         a.winding().IsInside(b.bvh().corners(0).row(0));
}

// The meshes, before and now, of those that are not what they were.
std::deque<SearchableMesh> ChangedMeshes(
    const std::vector<TriangleSoup>& before,
    const std::vector<const SearchableMesh*>& now) {
  std::deque<SearchableMesh> changed;
  for (size_t i = 0; i < now.size(); ++i) {
    if (AreSame(before[i], now[i]->soup())) continue;
    changed.emplace_back(before[i]);
    changed.push_back(*now[i]);
  }
  return changed;
}

std::vector<TriangleSoup> SoupsOf(
    const std::vector<const SearchableMesh*>& meshes) {
  std::vector<TriangleSoup> soups;
  for (const SearchableMesh* mesh : meshes) soups.push_back(mesh->soup());
  return soups;
}

}  // namespace

std::vector<char> AreStillKnown(
    const KnownCells& known,
    const std::vector<const SearchableMesh*>& muscles,
    const std::vector<const SearchableMesh*>& bones,
    double reach) {
  std::vector<char> are_known(muscles.size(), false);
  if (known.muscles.size() != muscles.size() ||
      known.bones.size() != bones.size()) {
    return are_known;
  }
  std::deque<SearchableMesh> changed = ChangedMeshes(known.muscles, muscles);
  for (SearchableMesh& bone : ChangedMeshes(known.bones, bones)) {
    changed.push_back(bone);
  }
  for (size_t i = 0; i < muscles.size(); ++i) {
    are_known[i] =
        AreSame(known.muscles[i], muscles[i]->soup()) &&
        std::none_of(
            changed.begin(), changed.end(), [&](const SearchableMesh& mesh) {
              return AreNear(*muscles[i], mesh, reach);
            });
  }
  return are_known;
}

void Remember(const std::vector<const SearchableMesh*>& muscles,
              const std::vector<const SearchableMesh*>& bones,
              const std::vector<Points>& projected,
              KnownCells* known) {
  *known = {SoupsOf(muscles), SoupsOf(bones), projected};
}

}  // namespace musclewarp
