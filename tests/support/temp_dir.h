// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// A fresh, empty folder named after the running test.
std::string TestTempDir();

}  // namespace musclewarp
