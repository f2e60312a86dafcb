// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// A folder named after the running test, which may not exist yet.
std::string TestTempPath();

// The same, fresh and empty.
std::string TestTempDir();

}  // namespace musclewarp
