// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/anatomy/bone.h"

namespace musclewarp {

// Returns the words of a name in lower case: what lies between signs that are
// neither letters nor digits.
std::vector<std::string> WordsOfName(const std::string& name);

// The kind and side of a bone, by its name.
struct NamedBone {
  // False for a name that is not known as that of a bone.
  bool is_known = false;

  // kOther for bones of no joint, such as ribs, too.
  BoneKind kind = BoneKind::kOther;
  std::optional<Side> side;
};

// Reads the name of a bone: words in any case between any signs that are
// neither letters nor digits, of which the first or the last may be the side:
// "left", "right", "l" or "r". Known are the names of TotalSegmentator
// ("femur_left", "hip_right", "tarsal"), of OpenSim's models ("calcn_r") and of
// anatomy ("os_coxae", "calcaneus", "metatarsal_3", "rib_left_4").
NamedBone ParseBoneName(const std::string& name);

// Returns the kind that the column "bone" of a table names, such as "femur", or
// nothing for a name that is not known.
std::optional<BoneKind> ParseBoneKind(const std::string& name);

// Returns the side that a text names, or nothing.
std::optional<Side> ParseSide(const std::string& text);

// Returns the side that a name tells, or nothing: right for "tib_ant_r", "Right
// soleus" and "long head of right biceps femoris".
std::optional<Side> SideOfName(const std::string& name);

// Returns the known names that are nearest to a name by the number of letters
// to change, at most three.
std::vector<std::string> NearestBoneNames(const std::string& name);

// Returns a bone whose kind and side follow from its name.
Bone BoneOfName(const std::string& name, TriangleSoup mesh);

// Returns the note for the user on a bone whose name is not known.
std::string NoteOnUnknownBone(const std::string& name);

}  // namespace musclewarp
