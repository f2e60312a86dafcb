// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/subject/described_bone.h"

#include <optional>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/short_list.h"
#include "musclewarp/scene/scene_names.h"

namespace musclewarp {

NamedBone DescribedBone(const LabelEntry& entry, const std::string& table) {
  NamedBone described = ParseBoneName(entry.name);
  const std::string where = table + ": " + QuotedName(entry.name) + ": column ";
  if (!entry.bone.empty()) {
    const std::optional<BoneKind> kind = ParseBoneKind(entry.bone);
    if (!kind) {
      throw InputError(
          where + "bone",
          "has " + QuotedName(entry.bone) + ", which is not known as a bone",
          "names near it: " + ShortList(NearestBoneNames(entry.bone)));
    }
    described.is_known = true;
    described.kind = *kind;
  }
  if (!entry.side.empty()) {
    described.side = ParseSide(entry.side);
    if (!described.side) {
      throw InputError(where + "side",
                       "has " + QuotedName(entry.side),
                       "allowed: right, left, or nothing");
    }
  }
  return described;
}

}  // namespace musclewarp
