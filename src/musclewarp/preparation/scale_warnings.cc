// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/preparation/scale_warnings.h"

#include <sstream>

namespace musclewarp {

std::vector<std::string> ScaleWarnings(const std::vector<MeshSize>& sizes,
                                       double ratio) {
  std::vector<std::string> warnings;
  for (size_t a = 0; a < sizes.size(); ++a) {
    for (size_t b = 0; b < sizes.size(); ++b) {
      if (sizes[a].diagonal <= ratio * sizes[b].diagonal) continue;
      std::ostringstream text;
      text << sizes[a].name << " is " << sizes[a].diagonal << " mm across, "
           << sizes[b].name << " " << sizes[b].diagonal
           << " mm: are both files in millimetres?";
      warnings.push_back(text.str());
    }
  }
  return warnings;
}

}  // namespace musclewarp
