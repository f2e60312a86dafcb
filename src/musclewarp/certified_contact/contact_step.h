// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "musclewarp/certified_contact/contact_state.h"
#include "musclewarp/certified_contact/muscle_surface.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// The muscles and bones of a scene as certified contact sees them, muscles in
// the order of their names, so that not even rounding depends on their order in
// the scene. Constant once it is prepared.
struct ContactScene {
  std::vector<MuscleSurface> muscles;
  std::vector<std::shared_ptr<const TriangleBvh>> bones;  // in the rest pose
};

// One step of contact, from a state in which no triangles cross to a nearby
// place of the bones and of the coarse meshes: everything about it that is
// known before it is taken.
struct ContactStep {
  const ContactScene& scene;
  const ContactState& before;

  // The place of each bone after the step.
  std::vector<Eigen::Matrix4d> bones_from_rest;

  // By muscle: what is attached, where it is after the step.
  std::vector<AttachedPoints> attached;

  // Where the vertices of each muscle are carried by their coarse mesh if they
  // keep their offsets, #V x 3, mm.
  std::vector<Points> predicted;

  // By muscle: a tree over its triangles before the step.
  std::vector<TriangleBvh> trees_before;

  // By muscle and triangle: its rotation from before the step to where it is
  // carried, for row vectors.
  std::vector<std::vector<Eigen::Matrix3d>> rotations;

  int num_muscles() const { return static_cast<int>(scene.muscles.size()); }
  int num_bones() const { return static_cast<int>(scene.bones.size()); }
};

// Describes the step from `before` to where the coarse meshes have the vertices
// at `targets` (#V x 3 each, mm) and the bones are at `bones_from_rest`.
// `attached`: by muscle, or empty if nothing is attached. Keeps references to
// the scene and to `before`. Preconditions (CHECKed): there is a state for
// every muscle and bone.
ContactStep MakeContactStep(const ContactScene& scene,
                            const ContactState& before,
                            const std::vector<Points>& targets,
                            std::vector<Eigen::Matrix4d> bones_from_rest,
                            std::vector<AttachedPoints> attached = {});

// Returns a tree over the triangles of each muscle where the step carries them.
// The functions of a step fit these trees to the places that they search, so
// that none of them has to build its own.
std::vector<TriangleBvh> PredictedTrees(const ContactStep& step);

}  // namespace musclewarp
