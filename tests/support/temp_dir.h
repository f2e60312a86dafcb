// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// Returns the path of a folder that is named after the running test and may not
// exist yet; the folder it is in does. When the test ends, the folder is
// removed; that of a test that failed stays, to be looked at.
std::string TestTempPath();

// Returns the same path, and makes the folder there: fresh and empty.
std::string TestTempDir();

}  // namespace musclewarp
