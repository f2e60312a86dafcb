// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// The folder with the public data sets, which MUSCLEWARP_DATA_ROOT names; empty
// if the variable is not set or is empty. Tests on real data begin with
//
//   const std::string root = DataRoot();
//   if (root.empty()) GTEST_SKIP() << kNoDataRoot;
std::string DataRoot();

// Why such a test is skipped.
constexpr char kNoDataRoot[] = "MUSCLEWARP_DATA_ROOT names no folder";

}  // namespace musclewarp
