// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "musclewarp/certified_contact/contact_state.h"
#include "musclewarp/certified_contact/muscle_surface.h"
#include "musclewarp/certified_contact/step_options.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

// The surfaces that certified contact keeps apart. Muscles are ordered by name,
// so that not even rounding depends on their order in the scene. Constant after
// preparation.
struct ContactScene {
  std::vector<MuscleSurface> muscles;
  std::vector<std::shared_ptr<const TriangleBvh>> bones;  // in the rest pose
};

// The input of one step of certified contact, shared by its stages: the
// intersection-free state before, and the nearby bones and coarse meshes to
// which the step leads.
struct ContactStep {
  const ContactScene& scene;
  const ContactState& before;

  // The transform of each bone after the step.
  std::vector<Eigen::Matrix4d> bones_from_rest;

  // By muscle: the attached vertices and their positions after the step.
  std::vector<AttachedPoints> attached;

  // The predicted vertices of each muscle, #V x 3, mm: the targets plus the
  // offsets before the step.
  std::vector<Points> predicted;

  // By muscle: whether it stands still, as bones do, while others move out of
  // its way.
  std::vector<char> is_still;

  // By muscle: its reach (StepOptions::reach), mm. Empty: that of the options.
  std::vector<double> reaches = {};

  // By muscle: a tree over its triangles before the step.
  std::vector<TriangleBvh> trees_before;

  // By muscle and triangle: its rotation from before the step to the
  // prediction, for row vectors.
  std::vector<std::vector<Eigen::Matrix3d>> rotations;

  int num_muscles() const { return static_cast<int>(scene.muscles.size()); }
  int num_bones() const { return static_cast<int>(scene.bones.size()); }
};

// Makes the step from `before` to coarse meshes that interpolate the vertices
// `targets` (#V x 3 each, mm) and to bones at `bones_from_rest`. `attached`: by
// muscle, or empty without attachments. `is_still`: by muscle, or empty if all
// move; the targets of muscles that stand still are those before. Keeps
// references to the scene and to `before`. Preconditions (CHECKed): `before`,
// `targets` and `bones_from_rest` cover every muscle and bone.
ContactStep MakeContactStep(const ContactScene& scene,
                            const ContactState& before,
                            const std::vector<Points>& targets,
                            std::vector<Eigen::Matrix4d> bones_from_rest,
                            std::vector<AttachedPoints> attached = {},
                            std::vector<char> is_still = {});

// Returns the reach of a muscle in a step, mm.
double ReachOf(const StepOptions& options, const ContactStep& step, int muscle);

// Returns a tree over the predicted triangles of each muscle. FindDefects()
// refits these trees instead of building its own.
std::vector<TriangleBvh> PredictedTrees(const ContactStep& step);

}  // namespace musclewarp
