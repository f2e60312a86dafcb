// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/build_info/build_info.h"

namespace musclewarp {

const char* const kVersion = MUSCLEWARP_VERSION;

std::string CodeKey() {
  return std::string(kVersion) + " " + kSourcesHash + " " + kBuiltWith;
}

std::string VersionText() {
  return std::string(kVersion) + " (sources " + kSourcesHash + ")";
}

}  // namespace musclewarp
