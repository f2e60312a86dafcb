// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/muscle_facts.h"

#include <glog/logging.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "musclewarp/anatomy/muscle_names.h"
#include "musclewarp/anatomy/muscle_rows.h"

namespace musclewarp {
namespace {

std::vector<AnatomicalEnd> EndsOf(const char* landmarks, const char* source) {
  std::vector<AnatomicalEnd> ends;
  std::istringstream stream(landmarks);
  for (std::string landmark; stream >> landmark;) {
    ends.push_back({landmark, PlacesOfLandmark(landmark), source});
  }
  return ends;
}

std::vector<std::string> MainBones(const std::vector<AnatomicalEnd>& ends) {
  std::vector<std::string> bones;
  for (const AnatomicalEnd& end : ends) {
    const std::string& bone = end.places.front().bone;
    if (std::find(bones.begin(), bones.end(), bone) == bones.end()) {
      bones.push_back(bone);
    }
  }
  return bones;
}

std::vector<std::string> AliasesOf(const char* text) {
  std::vector<std::string> aliases;
  std::istringstream stream(text);
  for (std::string alias; std::getline(stream >> std::ws, alias, ',');) {
    aliases.push_back(alias);
  }
  return aliases;
}

MuscleFacts FactsOf(const MuscleRow& row) {
  MuscleFacts facts;
  facts.name = row.name;
  facts.fma_id = row.fma_id;
  facts.origin_ends = EndsOf(row.origins, row.source);
  facts.insertion_ends = EndsOf(row.insertions, row.source);
  CHECK(!facts.origin_ends.empty() && !facts.insertion_ends.empty())
      << row.name << " has no end";
  facts.pulleys = EndsOf(row.pulleys, row.source);
  facts.origins = MainBones(facts.origin_ends);
  facts.insertions = MainBones(facts.insertion_ends);
  facts.aliases = AliasesOf(row.aliases);
  return facts;
}

std::map<std::string, const MuscleFacts*> FactsByKey() {
  std::map<std::string, const MuscleFacts*> by_key;
  for (const MuscleFacts& facts : AllMuscleFacts()) {
    by_key.emplace(MuscleKey(facts.name), &facts);
    for (const std::string& alias : facts.aliases) {
      const auto entry = by_key.emplace(MuscleKey(alias), &facts).first;
      CHECK(entry->second == &facts)
          << alias << " is " << facts.name << " and " << entry->second->name;
    }
  }
  return by_key;
}

}  // namespace

const std::vector<MuscleFacts>& AllMuscleFacts() {
  static const auto* all = [] {
    auto* facts = new std::vector<MuscleFacts>();
    for (const auto& rows : {MuscleRowsOfThigh(),
                             MuscleRowsOfLeg(),
                             MuscleRowsOfShoulder(),
                             MuscleRowsOfForearm()}) {
      for (const MuscleRow& row : rows) facts->push_back(FactsOf(row));
    }
    return facts;
  }();
  return *all;
}

const MuscleFacts* FindMuscleFacts(const std::string& name) {
  static const auto* by_key =
      new std::map<std::string, const MuscleFacts*>(FactsByKey());
  const auto found = by_key->find(MuscleKey(name));
  return found == by_key->end() ? nullptr : found->second;
}

}  // namespace musclewarp
