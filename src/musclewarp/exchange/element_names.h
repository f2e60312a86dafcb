// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>

namespace musclewarp {

// Names as element files take them: letters, digits and underscores, a letter
// first, at most 72 characters, and none that differs from another one by its
// case only. What a name becomes depends on the names before it.
class ElementNames {
 public:
  // Returns the name for a text, always the same one.
  const std::string& Of(const std::string& text);

 private:
  std::map<std::string, std::string> names_;
  std::set<std::string> taken_;  // in small letters
};

}  // namespace musclewarp
