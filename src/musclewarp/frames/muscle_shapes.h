// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/frames/scene_state.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// Where the vertices of the muscles of a scene are, by muscle, in the order of
// the scene: all that a frame shows of them.
struct MuscleShapes {
  std::vector<Points> coarse;  // N x 3, mm
  std::vector<Points> fine;    // n x 3, mm
};

// Returns the shapes of muscles in these states.
MuscleShapes ShapesOf(const PreparedScene& scene,
                      const std::vector<MuscleState>& states);

// Returns the fine vertices of the muscles of a state without certified
// contact, n x 3 each, mm; none if it is null.
std::vector<Points> FinePointsOf(const PreparedScene& scene,
                                 const SceneState* state);

}  // namespace musclewarp
