// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/certified_contact/contact_state.h"
#include "musclewarp/motion/certified_motion.h"
#include "musclewarp/motion/muscle_solvers.h"
#include "musclewarp/preparation/prepared_scene.h"

namespace musclewarp {

// What does not change while a scene in contact moves. Keeps references.
struct MotionContext {
  const PreparedScene& scene;
  const CertifiedScene& certified;
  const PreRotationOptions& pre_rotation;
  const MuscleSolver& solver;
};

// Returns the fine vertices of muscles, #V x 3 each, mm, where their coarse
// meshes have them. `coarse`: N x 3 each, mm. Both in the order of contact.
std::vector<Points> FineMeshes(const CertifiedScene& certified,
                               const std::vector<Points>& coarse);

// Returns the place of each bone in a pose.
std::vector<Eigen::Matrix4d> BonesFromRest(const PreparedScene& scene,
                                           const ScenePose& pose);

// Returns where bones have the attached vertices of muscles in a pose, in the
// order of contact; nothing before the rest pose is known.
std::vector<AttachedPoints> AttachedIn(const CertifiedScene& certified,
                                       const ScenePose& pose);

// Returns the state of muscles with the coarse vertices `coarse` (N x 3 each,
// mm, in the order of contact) that contact neither moves nor holds.
ContactState StateWithoutContact(const PreparedScene& scene,
                                 const CertifiedScene& certified,
                                 const ScenePose& pose,
                                 std::vector<Points> coarse);

}  // namespace musclewarp
