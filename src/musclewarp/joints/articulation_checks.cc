// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/articulation_checks.h"

#include <algorithm>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/base/text.h"
#include "musclewarp/joints/joint_building.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {

void CheckBoneSize(const Bone& bone) {
  constexpr double kLargest = 1e4;  // mm: no bone of any animal is so long
  const double diagonal = BoundingBoxDiagonal(bone.mesh.points);
  if (diagonal <= kLargest) return;
  throw InputError(
      bone.name,
      "is " + RoundedText(diagonal / 1000, 1) + " m long, allowed: 10 m",
      "give the unit of the files ({units})");
}

void CheckJointsAreThere(const ArticulationOptions& options,
                         const std::vector<std::string>& names,
                         bool lacks_sides,
                         const std::vector<FoundJoint>& joints) {
  for (const JointKind kind : options.joints) {
    const bool is_there = std::any_of(
        joints.begin(), joints.end(), [&](auto& j) { return j.kind == kind; });
    if (is_there) continue;
    throw InputError("joint " + ToString(kind),
                     "lacks its bones",
                     "name the meshes as bones (docs/joints.md), or give a "
                     "table with a column \"bone\"");
  }
  if (!joints.empty()) return;
  if (names.empty()) {
    throw InputError("bones",
                     "none given",
                     "name meshes or labels as bones (docs/joints.md)");
  }
  const std::string side =
      options.side ? " of the " + ToString(*options.side) + " side" : "";
  throw InputError("joints",
                   "none" + side + " has its bones among " + ShortList(names),
                   lacks_sides
                       ? "give their sides by {side} or by their names, such "
                         "as femur_r, as nothing else tells them"
                       : "name the meshes as bones (docs/joints.md), or give "
                         "a table with a column \"bone\"");
}

}  // namespace musclewarp
