// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "python/src/figures.h"

#include <regex>
#include <sstream>

#include "musclewarp/base/setting_names.h"

namespace musclewarp::python {

std::string PlainText(const std::string& text) {
  static const std::regex kLink(R"(\[([^\]]*)\]\([^)]*\))");
  std::string plain = std::regex_replace(WithFieldNames(text), kLink, "$1");
  plain.erase(std::remove(plain.begin(), plain.end(), '`'), plain.end());
  return plain;
}

std::string AttributeText(const std::string& name,
                          const std::string& text,
                          const std::string& unit,
                          int indent) {
  constexpr size_t kWidth = 79;
  const std::string said =
      name + ": " + PlainText(text) + (unit.empty() ? "" : ", " + unit) + ".";
  std::istringstream words(said);
  std::string lines(indent, ' ');
  size_t used = lines.size();
  for (std::string word; words >> word;) {
    const bool is_first = word == name + ":";
    if (!is_first && used + 1 + word.size() > kWidth) {
      lines += "\n" + std::string(indent + 4, ' ') + word;
      used = indent + 4 + word.size();
    } else {
      lines += (is_first ? "" : " ") + word;
      used += word.size() + (is_first ? 0 : 1);
    }
  }
  return lines;
}

}  // namespace musclewarp::python
