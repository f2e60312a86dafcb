// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/lost_parts.h"

#include <algorithm>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/triangle_difference.h"
#include "musclewarp/mesh_files/mesh_path.h"

namespace musclewarp {
namespace {

bool HasDropped(const RepairReport& repairs, DropReason reason) {
  return std::any_of(
      repairs.dropped_pieces.begin(),
      repairs.dropped_pieces.end(),
      [&](const DroppedPiece& piece) { return piece.reason == reason; });
}

bool IsClosed(const TriangleSoup& mesh) {
  for (const EdgeUses::Uses& uses : EdgeUses(mesh.triangles)) {
    if (uses.size() == 1) return false;
  }
  return true;
}

// Returns true if no triangle of a part remains. A part without area cannot be
// lost, and a crumb only if it is closed: flaps and scraps are not.
bool IsLost(const TriangleSoup& part,
            const TriangleSoup& repaired,
            bool may_be_crumb) {
  const Eigen::Index with_area =
      TrianglesNotIn(part, TriangleSoup{Points(0, 3), Triangles(0, 3)})
          .triangles.rows();
  return with_area > 0 &&
         TrianglesNotIn(part, repaired).triangles.rows() == with_area &&
         (!may_be_crumb || IsClosed(part));
}

}  // namespace

void CheckNoPartIsLost(const std::string& path,
                       const MeshParts& parts,
                       const TriangleSoup& delivered,
                       const TriangleSoup& repaired,
                       const RepairReport& repairs) {
  const int count = static_cast<int>(parts.names.size());
  const bool has_smaller = HasDropped(repairs, DropReason::kSmaller);
  if (count < 2 || !(has_smaller || HasDropped(repairs, DropReason::kCrumb))) {
    return;
  }
  bool is_lost = false;
  for (int part = 0; part < count && !is_lost; ++part) {
    is_lost =
        IsLost(MeshOfPart(delivered, parts, part), repaired, !has_smaller);
  }
  if (!is_lost) return;
  std::vector<std::string> names;
  for (const std::string& name : parts.names) {
    if (std::count(names.begin(), names.end(), name) == 0) {
      names.push_back(name);
    }
  }
  const std::string one = MeshFileOf(path) + "#" + names[0];
  const bool can_be_named = names.size() > 1;
  throw InputError(
      path,
      "has " + std::to_string(can_be_named ? names.size() : count) + " " +
          parts.kind + (can_be_named ? "s: " : "s of the name ") +
          ShortList(names, 30) +
          "; a muscle is one closed surface, and one of them would be lost",
      (can_be_named ? "name the one that is meant, such as \"" + one + "\""
                    : std::string("give each a name of its own in the file")) +
          "; separation with {pieces}=all makes a mesh of each");
}

}  // namespace musclewarp
