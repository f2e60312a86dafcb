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

// The constant inputs of a motion with contact, shared by all its steps. Keeps
// references.
struct MotionContext {
  const PreparedScene& scene;
  const CertifiedScene& certified;
  const PreRotationOptions& pre_rotation;
  const MuscleSolver& solver;
};

// Returns the fine vertices of muscles, #V x 3 each, mm, interpolated from the
// coarse vertices `coarse`, N x 3 each, mm. Both in the order of contact.
std::vector<Points> FineMeshes(const CertifiedScene& certified,
                               const std::vector<Points>& coarse);

// Returns the transform of each bone from the rest pose to a pose.
std::vector<Eigen::Matrix4d> BonesFromRest(const PreparedScene& scene,
                                           const ScenePose& pose);

// Returns the positions in a pose of the vertices attached to bones, in the
// order of contact. Empty before the rest pose is known.
std::vector<AttachedPoints> AttachedIn(const CertifiedScene& certified,
                                       const ScenePose& pose);

// Returns the state without contact of muscles with the coarse vertices
// `coarse`, N x 3 each, mm, in the order of contact: no offsets, no attached
// vertices and no planes.
ContactState StateWithoutContact(const PreparedScene& scene,
                                 const CertifiedScene& certified,
                                 const ScenePose& pose,
                                 std::vector<Points> coarse);

}  // namespace musclewarp
