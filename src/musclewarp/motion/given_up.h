// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace musclewarp {

// Why the remainder of a motion with certified contact was computed without
// contact.
enum class GivenUp {
  kNot,
  kTimedOut,
  kStuck,      // triangles crossed for too many steps in a row
  kNotFinite,  // every step came to coordinates that are not finite
};

}  // namespace musclewarp
