// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "musclewarp/geometry/outer_hull.h"
#include "musclewarp/motion/prepared_scene.h"
#include "musclewarp/paper_contact/contact_body.h"
#include "musclewarp/paper_contact/group_contact.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

struct PaperSceneOptions {
  GroupContactOptions group;

  // Of the hulls of bones, which the coarse level needs. More vertices than
  // those of muscles: nothing is solved on them, and they decide how near a
  // muscle may come.
  OuterHullOptions bone_hull;

  PaperSceneOptions() { bone_hull.coarse_vertices = 1000; }
  bool IsValid(std::string* error) const;
};

// The meshes of a scene as contact sees them. Constant from then on.
struct PaperScene {
  using Shapes = std::vector<std::unique_ptr<const ContactShape>>;
  PaperSceneOptions options;
  Shapes muscle_hulls, bone_hulls;  // none at the fine level
  Shapes muscles, bones;
  // Meshes that lie inside others or are there twice: contact has an answer for
  // them, but hardly the one that is wanted.
  std::vector<std::string> warnings;
  double wall_ms = 0;
};

// Preconditions (CHECKed): the options are valid.
PaperScene PreparePaperScene(const PreparedScene& scene,
                             const PaperSceneOptions& options);

// The contact of one pose: bones where the pose has them, muscles at rest.
// Keeps pointers to both.
GroupContact ContactInPose(const PreparedScene& scene,
                           const PaperScene& contact,
                           const ScenePose& pose);

}  // namespace musclewarp
