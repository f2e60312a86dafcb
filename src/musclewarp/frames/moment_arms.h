// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/frames/frame.h"
#include "musclewarp/frames/muscle_shapes.h"
#include "musclewarp/frames/plane_rates.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/solver/muscle_target.h"

namespace musclewarp {

// The shapes of a scene in a pose, of which moment arms are derivatives.
struct ConvergedShapes {
  // The coarse vertices of each muscle, X, and what they interpolate, W X.
  MuscleShapes muscles;

  // With certified contact: what held each muscle there, and the coarse
  // vertices without contact. Else both are empty.
  std::vector<ContactRows> contact;
  std::vector<Points> free_coarse;
};

// Adds to a frame the moment arms -dl/dq of its lines and fibres as their
// muscles carry them, for all coordinates of MomentArmCoordinates. They are
// exact derivatives of the lengths in the frame, by implicit differentiation of
// the solves (DifferentiateShape), with active contacts held: none comes or
// goes, the plane of a bone moves with it, and one between two muscles goes
// along with the shapes that both would have without contact.
//
// A scene without a model has no moment arms. `frame` must be that of the same
// shapes.
void AddMomentArms(const PreparedScene& scene,
                   const ScenePose& pose,
                   const PreRotationOptions& pre_rotation,
                   const ConvergedShapes& shapes,
                   Frame* frame);

// Adds those of the straight lines only (PathMomentArms). AddMomentArms does so
// too.
void AddPathMomentArms(const PreparedScene& scene,
                       const ScenePose& pose,
                       Frame* frame);

}  // namespace musclewarp
