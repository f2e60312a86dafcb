// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/bone_names.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

#include "musclewarp/base/near_name.h"

namespace musclewarp {
namespace {

// Names without side and number, in words with underscores between them.
const std::map<std::string, BoneKind>& KnownNames() {
  static const auto* names = new std::map<std::string, BoneKind>{
      {"pelvis", BoneKind::kPelvis},
      {"pelvis_no_sacrum", BoneKind::kPelvis},
      {"hip", BoneKind::kHipBone},
      {"hip_bone", BoneKind::kHipBone},
      {"hipbone", BoneKind::kHipBone},
      {"coxa", BoneKind::kHipBone},
      {"os_coxae", BoneKind::kHipBone},
      {"innominate", BoneKind::kHipBone},
      {"hemipelvis", BoneKind::kHipBone},
      {"sacrum", BoneKind::kSacrum},
      {"femur", BoneKind::kFemur},
      {"patella", BoneKind::kPatella},
      {"tibia", BoneKind::kTibia},
      {"tibia_no_fib", BoneKind::kTibia},
      {"tibia_fibula", BoneKind::kTibia},
      {"fibula", BoneKind::kFibula},
      {"talus", BoneKind::kTalus},
      {"astragalus", BoneKind::kTalus},
      {"calcn", BoneKind::kFoot},
      {"calcaneus", BoneKind::kFoot},
      {"foot", BoneKind::kFoot},
      {"tarsal", BoneKind::kFoot},
      {"tarsals", BoneKind::kFoot},
      {"metatarsal", BoneKind::kFoot},
      {"metatarsals", BoneKind::kFoot},
      {"navicular", BoneKind::kFoot},
      {"cuboid", BoneKind::kFoot},
      {"cuneiform", BoneKind::kFoot},
      {"cuneiform_medial", BoneKind::kFoot},
      {"cuneiform_intermediate", BoneKind::kFoot},
      {"cuneiform_lateral", BoneKind::kFoot},
      {"medial_cuneiform", BoneKind::kFoot},
      {"intermediate_cuneiform", BoneKind::kFoot},
      {"lateral_cuneiform", BoneKind::kFoot},
      {"toes", BoneKind::kFoot},
      {"toe", BoneKind::kFoot},
      {"toe_proximal", BoneKind::kFoot},
      {"toe_middle", BoneKind::kFoot},
      {"toe_distal", BoneKind::kFoot},
      {"phalanges_feet", BoneKind::kFoot},
      {"phalanges_foot", BoneKind::kFoot},
      {"scapula", BoneKind::kScapula},
      {"clavicle", BoneKind::kClavicle},
      {"clavicula", BoneKind::kClavicle},
      {"humerus", BoneKind::kHumerus},
      {"ulna", BoneKind::kUlna},
      {"radius", BoneKind::kRadius},
  };
  return *names;
}

bool IsNumber(const std::string& word) {
  return std::all_of(word.begin(), word.end(), [](unsigned char letter) {
    return std::isdigit(letter) != 0;
  });
}

// The words without numbers, which count bones of one kind.
std::string Joined(const std::vector<std::string>& words) {
  std::string joined;
  for (const std::string& word : words) {
    if (IsNumber(word)) continue;
    joined += (joined.empty() ? "" : "_") + word;
  }
  return joined;
}

// Returns true for the names of bones that belong to no joint here.
bool HasWordOfOtherBones(const std::vector<std::string>& words) {
  static const auto* others = new std::set<std::string>{"rib",
                                                        "ribs",
                                                        "vertebra",
                                                        "vertebrae",
                                                        "sternum",
                                                        "skull",
                                                        "cranium",
                                                        "mandible",
                                                        "carpal",
                                                        "carpals",
                                                        "hand",
                                                        "metacarpal",
                                                        "metacarpals",
                                                        "coccyx",
                                                        "hyoid",
                                                        "phalanx",
                                                        "phalanges",
                                                        "finger",
                                                        "fingers"};
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return others->count(word) > 0;
  });
}

}  // namespace

std::vector<std::string> WordsOfName(const std::string& name) {
  std::vector<std::string> words(1);
  for (const char letter : name) {
    if (std::isalnum(static_cast<unsigned char>(letter)) != 0) {
      words.back() +=
          static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::string ToString(Side side) {
  return side == Side::kRight ? "right" : "left";
}

std::string SuffixOf(Side side) { return side == Side::kRight ? "_r" : "_l"; }

std::optional<Side> ParseSide(const std::string& text) {
  if (text == "right" || text == "r") return Side::kRight;
  if (text == "left" || text == "l") return Side::kLeft;
  return std::nullopt;
}

std::optional<Side> SideOfName(const std::string& name) {
  const std::vector<std::string> words = WordsOfName(name);
  if (words.empty()) return std::nullopt;
  if (const auto side = ParseSide(words.back())) return side;
  if (const auto side = ParseSide(words.front())) return side;
  for (const std::string& word : words) {
    if (word.size() == 1) continue;  // an initial, perhaps
    if (const auto side = ParseSide(word)) return side;
  }
  return std::nullopt;
}

NamedBone ParseBoneName(const std::string& name) {
  NamedBone bone;
  std::vector<std::string> words = WordsOfName(name);
  if (words.size() > 1) {
    bone.side = ParseSide(words.back());
    if (bone.side) {
      words.pop_back();
    } else if ((bone.side = ParseSide(words.front()))) {
      words.erase(words.begin());
    }
  }
  const auto known = KnownNames().find(Joined(words));
  if (known != KnownNames().end()) {
    bone.is_known = true;
    bone.kind = known->second;
  } else {
    bone.is_known = HasWordOfOtherBones(words);
  }
  return bone;
}

std::optional<BoneKind> ParseBoneKind(const std::string& name) {
  const auto known = KnownNames().find(Joined(WordsOfName(name)));
  if (known == KnownNames().end()) return std::nullopt;
  return known->second;
}

std::vector<std::string> NearestBoneNames(const std::string& name) {
  constexpr size_t kMost = 3;
  std::vector<std::string> words = WordsOfName(name);
  if (words.size() > 1 && ParseSide(words.back())) words.pop_back();
  if (words.size() > 1 && ParseSide(words.front())) words.erase(words.begin());
  const std::string joined = Joined(words);
  std::vector<std::pair<int, std::string>> near;
  for (const auto& [known, kind] : KnownNames()) {
    near.emplace_back(EditDistance(joined, known), known);
  }
  std::sort(near.begin(), near.end());
  near.resize(std::min(near.size(), kMost));
  std::vector<std::string> names;
  for (const auto& entry : near) names.push_back(entry.second);
  return names;
}

Bone BoneOfName(const std::string& name, TriangleSoup mesh) {
  const NamedBone named = ParseBoneName(name);
  Bone bone;
  bone.name = name;
  bone.kind = named.kind;
  bone.side = named.side;
  bone.mesh = std::move(mesh);
  return bone;
}

std::string NoteOnUnknownBone(const std::string& name) {
  std::string near;
  for (const std::string& known : NearestBoneNames(name)) {
    near += (near.empty() ? "" : ", ") + known;
  }
  return name +
         ": not known as a bone, and of no joint; known names near it: " + near;
}

}  // namespace musclewarp
