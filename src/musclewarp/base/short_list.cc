// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/short_list.h"

#include <algorithm>

namespace musclewarp {

std::string ShortList(const std::vector<std::string>& texts, std::size_t most) {
  std::string list;
  for (std::size_t i = 0; i < std::min(texts.size(), most); ++i) {
    list += (i == 0 ? "" : ", ") + texts[i];
  }
  if (texts.size() > most) {
    list += " and " + std::to_string(texts.size() - most) + " more";
  }
  return list;
}

}  // namespace musclewarp
