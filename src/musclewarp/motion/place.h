// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/motion/certified_motion.h"
#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/motion/prepared_scene.h"
#include "musclewarp/motion/solved_pose.h"

namespace musclewarp {

// What does not change while a scene moves. Keeps references.
struct Mover {
  const PreparedScene& scene;
  const CertifiedScene& certified;
  const PreRotationOptions& pre_rotation;
  const MuscleSolver& solver;
};

// Where a scene has come to on its way to a pose.
struct Place {
  ScenePose pose;
  SolvedPose free;    // without contact: what displacement is measured against
  SolvedPose solved;  // with contact rows
  ContactState surfaces;
};

// Returns the fine vertices of muscles, #V x 3 each, mm, in the order of
// contact.
std::vector<Points> FineMeshes(const Mover& mover,
                               const std::vector<MuscleState>& muscles);

// Returns the place of each bone in a pose.
std::vector<Eigen::Matrix4d> BonesFromRest(const PreparedScene& scene,
                                           const ScenePose& pose);

// Returns where bones have the attached vertices of muscles in a pose, in the
// order of contact; none before the rest pose is known.
std::vector<AttachedPoints> AttachedIn(const Mover& mover,
                                       const ScenePose& pose);

// Returns the place of a state. An offset of fine vertices that is missing
// counts as zero.
Place PlaceOf(const Mover& mover, const SceneState& state);

// Returns the state of a place.
SceneState StateOf(const Mover& mover, const Place& place);

}  // namespace musclewarp
