// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/settings/checked_settings.h"

#include <algorithm>

#include "musclewarp/base/near_name.h"
#include "musclewarp/base/text.h"

namespace musclewarp {

Choices ChoicesOf(const std::string& listed) {
  const size_t end = listed.find("; commas");
  Choices choices;
  choices.takes_several = end != std::string::npos;
  for (const std::string& word : Split(listed.substr(0, end), ',')) {
    choices.words.push_back(word.substr(word.find_first_not_of(' ')));
  }
  return choices;
}

void CheckChoice(const char* name,
                 const std::string& value,
                 const std::string& choices) {
  const Choices allowed = ChoicesOf(choices);
  if (allowed.words.empty()) return;
  const auto is_allowed = [&](const std::string& word) {
    return std::count(allowed.words.begin(), allowed.words.end(), word) > 0;
  };
  if (is_allowed(value)) return;
  const std::vector<std::string> several = Split(value, ',');
  if (allowed.takes_several && !several.empty() &&
      std::all_of(several.begin(), several.end(), is_allowed)) {
    return;
  }
  throw InputError(
      "{" + std::string(name) + "}=" + value,
      "is none of its values",
      DidYouMean(value, allowed.words) +
          "allowed: " + choices.substr(0, choices.find(';')) +
          (allowed.takes_several ? ", or several with commas" : ""));
}

void CheckNumber(const char* name,
                 double value,
                 const ValueRange& range,
                 const std::string& unit) {
  constexpr int kDigits = 15;  // of a number as it was given
  if (std::isfinite(value) && range.Contains(value)) return;
  throw InputError(
      "{" + std::string(name) + "}",
      "is " + NumberText(value, kDigits),
      "allowed: " + range.Text() + (unit.empty() ? "" : ", ") + unit);
}

}  // namespace musclewarp
