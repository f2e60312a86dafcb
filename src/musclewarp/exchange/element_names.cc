// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/element_names.h"

#include <cctype>

namespace musclewarp {
namespace {

// Abaqus and CalculiX take 80; endings such as _SURFACE need some of them.
constexpr size_t kLongest = 64;

std::string Plain(const std::string& text) {
  std::string plain;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    plain += byte < 128 && std::isalnum(byte) ? c : '_';
  }
  if (plain.empty() || !std::isalpha(static_cast<unsigned char>(plain[0]))) {
    plain = "m_" + plain;
  }
  return plain.substr(0, kLongest);
}

std::string SmallLetters(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

}  // namespace

const std::string& ElementNames::Of(const std::string& text) {
  const auto [found, is_new] = names_.try_emplace(text);
  if (!is_new) return found->second;
  const std::string plain = Plain(text);
  std::string name = plain;
  for (int i = 2; !taken_.insert(SmallLetters(name)).second; ++i) {
    name = plain + "_" + std::to_string(i);
  }
  return found->second = name;
}

}  // namespace musclewarp
