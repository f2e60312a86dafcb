// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/bone_match.h"

#include <cctype>
#include <map>
#include <set>

#include "musclewarp/anatomy/bone_names.h"

namespace musclewarp {
namespace {

// Words that mean the same as another one; those that mean nothing are empty.
const std::map<std::string, std::string>& Synonyms() {
  static const auto* synonyms = new std::map<std::string, std::string>{
      {"bone", ""},
      {"os", ""},
      {"of", ""},
      {"the", ""},
      {"phalanx", ""},
      {"calcn", "calcaneus"},
      {"tarsals", "tarsal"},
      {"metatarsals", "metatarsal"},
      {"toes", "toe"},
      {"carpals", "carpal"},
      {"fingers", "finger"},
      {"metacarpals", "metacarpal"},
      {"ribs", "rib"},
      {"vertebra", "vertebrae"},
      {"first", "1"},
      {"second", "2"},
      {"third", "3"},
      {"fourth", "4"},
      {"fifth", "5"},
      {"1st", "1"},
      {"2nd", "2"},
      {"3rd", "3"},
      {"4th", "4"},
      {"5th", "5"},
  };
  return *synonyms;
}

// Splits "metatarsal1" and "l3", which follow other words, before the number.
void InsertWord(const std::string& word, std::set<std::string>* words) {
  const auto synonym = Synonyms().find(word);
  if (synonym != Synonyms().end()) {
    if (!synonym->second.empty()) words->insert(synonym->second);
    return;
  }
  size_t letters = 0;
  while (letters < word.size() &&
         std::isdigit(static_cast<unsigned char>(word[letters])) == 0) {
    ++letters;
  }
  if (letters == 0 || letters == word.size()) {
    words->insert(word);
    return;
  }
  InsertWord(word.substr(0, letters), words);
  words->insert(word.substr(letters));
}

std::set<std::string> MeaningOf(const std::string& name) {
  std::vector<std::string> words = WordsOfName(name);
  if (words.size() > 1 && ParseSide(words.back())) {
    words.pop_back();
  } else if (words.size() > 1 && ParseSide(words.front())) {
    words.erase(words.begin());
  }
  std::set<std::string> meaning;
  for (const std::string& word : words) InsertWord(word, &meaning);
  // The phalanges, which are "toes" and "fingers" in the tables.
  if (meaning.erase("phalanges") > 0) {
    const bool are_of_foot = meaning.erase("feet") + meaning.erase("foot") > 0;
    if (are_of_foot || meaning.erase("hands") + meaning.erase("hand") > 0) {
      meaning.insert(are_of_foot ? "toe" : "finger");
    }
  }
  return meaning;
}

// Kinds of which the body has no more than one bone on each side.
bool IsOneBone(BoneKind kind) {
  return kind != BoneKind::kOther && kind != BoneKind::kFoot;
}

}  // namespace

bool NamesBone(const std::string& name, const std::string& bone) {
  const BoneKind kind = ParseBoneName(name).kind;
  const BoneKind named = ParseBoneName(bone).kind;
  if (IsOneBone(kind) || IsOneBone(named)) return kind == named;
  return MeaningOf(name) == MeaningOf(bone);
}

}  // namespace musclewarp
