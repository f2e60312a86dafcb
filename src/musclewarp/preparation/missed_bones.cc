// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/missed_bones.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "musclewarp/anatomy/bone_names.h"
#include "musclewarp/anatomy/muscle_facts.h"

namespace musclewarp {
namespace {

// Returns the bodies of the bones of a scene that are of the same kind as one
// of `named`.
std::set<std::string> BodiesOf(const std::vector<std::string>& named,
                               const std::optional<Side>& side,
                               const std::vector<SceneBone>& bones) {
  std::set<std::string> bodies;
  for (const SceneBone& bone : bones) {
    const NamedBone of_scene = ParseBoneName(bone.name);
    if (of_scene.kind == BoneKind::kOther) continue;
    if (side && of_scene.side && *side != *of_scene.side) continue;
    for (const std::string& name : named) {
      if (ParseBoneName(name).kind == of_scene.kind) bodies.insert(bone.body);
    }
  }
  return bodies;
}

bool Meet(const std::set<std::string>& a, const std::set<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&](const std::string& body) {
    return b.count(body) > 0;
  });
}

std::string Joined(const std::set<std::string>& names, const char* between) {
  std::string joined;
  for (const std::string& name : names) {
    joined += (joined.empty() ? "" : between) + name;
  }
  return joined;
}

}  // namespace

std::vector<std::string> MissedBones(const SceneMuscle& muscle,
                                     const std::vector<LineEnd>& ends,
                                     const std::vector<SceneBone>& bones) {
  const MuscleFacts* facts = FindMuscleFacts(muscle.name);
  if (!facts || ends.empty() || !muscle.end_bodies.empty()) return {};
  const std::optional<Side> side = SideOfName(muscle.name);
  const auto origins = BodiesOf(facts->origins, side, bones);
  const auto insertions = BodiesOf(facts->insertions, side, bones);
  if (Meet(origins, insertions)) return {};
  std::set<std::string> reached;
  for (const LineEnd& end : ends) reached.insert(end.body);
  std::vector<std::string> shortcomings;
  for (const auto& [named, bodies] :
       {std::pair(facts->origins, origins),
        std::pair(facts->insertions, insertions)}) {
    if (bodies.empty() || Meet(bodies, reached)) continue;
    shortcomings.push_back(
        muscle.name + " by its name ends on the " + named.front() +
        ", which moves with " + Joined(bodies, " or ") +
        ", but its lines end on " + Joined(reached, " and ") +
        ": is its tendon missing from the mesh? Add it to the mesh, or as a "
        "mesh of its own, or name the bodies in \"end_bodies\"");
  }
  return shortcomings;
}

}  // namespace musclewarp
