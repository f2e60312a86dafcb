// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace musclewarp {

// The bundle, as kPageBundle (page.h).
extern const char kJointsPageBundle[];
extern const unsigned long kJointsPageBundleSize;

}  // namespace musclewarp
