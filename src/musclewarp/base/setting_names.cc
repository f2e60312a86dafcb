// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/setting_names.h"

#include <cstddef>

namespace musclewarp {
namespace {

// Replaces each "{name}" by the prefix and the name. Braces around anything
// else, as those of JSON, stay.
std::string WithNames(const std::string& text, const std::string& prefix) {
  constexpr char kLetters[] = "abcdefghijklmnopqrstuvwxyz_";
  std::string named;
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t end = text.find_first_not_of(kLetters, at + 1);
    if (text[at] == '{' && end != std::string::npos && end > at + 1 &&
        text[end] == '}') {
      named += prefix + text.substr(at + 1, end - at - 1);
      at = end + 1;
    } else {
      named += text[at++];
    }
  }
  return named;
}

}  // namespace

std::string WithFlags(const std::string& text) { return WithNames(text, "--"); }

std::string WithFieldNames(const std::string& text) {
  return WithNames(text, "");
}

std::vector<std::string> WithFieldNames(std::vector<std::string> texts) {
  for (std::string& text : texts) text = WithFieldNames(text);
  return texts;
}

}  // namespace musclewarp
