// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/anatomy/muscle_names.h"

#include <cctype>
#include <map>
#include <set>
#include <vector>

#include "musclewarp/anatomy/bone_names.h"

namespace musclewarp {
namespace {

// Leaves nothing of a word of digits.
std::string WithoutNumber(std::string word) {
  while (!word.empty() &&
         std::isdigit(static_cast<unsigned char>(word.back())) != 0) {
    word.pop_back();
  }
  return word;
}

bool SaysNothing(const std::string& word) {
  static const auto* fillers = new std::set<std::string>{"belly",
                                                         "caput",
                                                         "head",
                                                         "muscle",
                                                         "muscles",
                                                         "musculi",
                                                         "musculus",
                                                         "of",
                                                         "pars",
                                                         "part",
                                                         "the"};
  return word.empty() || fillers->count(word) > 0;
}

// Removes words of one letter at both ends, which mean something only there.
void RemoveLettersAtEnds(std::vector<std::string>* words) {
  if (words->size() > 1 && ParseSide(words->back())) words->pop_back();
  if (words->size() > 1 && ParseSide(words->front())) {
    words->erase(words->begin());
  }
  if (words->size() > 1 && (words->front() == "m" || words->front() == "mm")) {
    words->erase(words->begin());
  }
}

std::string Modern(const std::string& word) {
  static const auto* modern = new std::map<std::string, std::string>{
      {"glutaeus", "gluteus"},
      {"peronaeus", "fibularis"},
      {"peroneus", "fibularis"},
  };
  const auto found = modern->find(word);
  return found == modern->end() ? word : found->second;
}

}  // namespace

std::string MuscleKey(const std::string& name) {
  std::vector<std::string> words;
  for (const std::string& numbered : WordsOfName(name)) {
    const std::string word = WithoutNumber(numbered);
    if (!SaysNothing(word) && word != "left" && word != "right") {
      words.push_back(word);
    }
  }
  RemoveLettersAtEnds(&words);
  std::string key;
  for (const std::string& word : words) key += Modern(word);
  return key;
}

}  // namespace musclewarp
