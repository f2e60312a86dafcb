// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "support/data_root.h"

#include <cstdlib>

namespace musclewarp {

std::string DataRoot() {
  const char* const root = std::getenv("MUSCLEWARP_DATA_ROOT");
  return root == nullptr ? "" : root;
}

}  // namespace musclewarp
