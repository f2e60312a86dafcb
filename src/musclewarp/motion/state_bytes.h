// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/frames/scene_state.h"

namespace musclewarp {

// Return a state as bytes, and the state that such bytes hold, bit for bit.
// What reads bytes throws a std::exception if they are not of a state.
std::string BytesOf(const SceneState& state);
SceneState StateFrom(const std::string& bytes);

}  // namespace musclewarp
