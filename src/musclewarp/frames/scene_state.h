// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "musclewarp/certified_contact/contact_state.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/scene_pose.h"
#include "musclewarp/solver/muscle_state.h"

namespace musclewarp {

// The muscles of a scene in a pose: where the next frame of a motion starts.
// Whoever has one need not know which kind of contact it is of.
struct SceneState {
  ScenePose pose;

  // In the order of the scene; none with certified contact.
  std::vector<MuscleState> muscles;

  // With certified contact, in the same pose.
  std::optional<ContactState> contact;

  bool IsEmpty() const { return muscles.empty() && !contact; }
};

// Returns the state of a scene with every muscle at rest, without contact.
SceneState RestState(const PreparedScene& scene);

}  // namespace musclewarp
