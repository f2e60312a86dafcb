// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "musclewarp/geometry/outer_hull.h"
#include "musclewarp/paper_contact/contact_body.h"
#include "musclewarp/paper_contact/group_contact.h"
#include "musclewarp/preparation/prepared_scene.h"
#include "musclewarp/scene/scene.h"

namespace musclewarp {

// Options of the paper's contact for a whole scene.
struct PaperSceneOptions {
  GroupContactOptions group;

  // The hulls of bones for contact at the coarse level. They have more vertices
  // than those of muscles: they add no unknowns, and their accuracy limits how
  // closely a muscle may approach a bone.
  OuterHullOptions bone_hull;

  // Hulls of bones are as near to them as may be.
  PaperSceneOptions() {
    bone_hull.coarse_vertices = 1000;
    bone_hull.relative_distance = 0;
  }

  // Also checks the nested options.
  bool IsValid(std::string* error) const;
};

// The contact shapes of a scene for the paper's contact, shared by all poses.
// Constant after preparation.
struct PaperScene {
  using Shapes = std::vector<std::unique_ptr<const ContactShape>>;
  PaperSceneOptions options;
  Shapes muscle_hulls, bone_hulls;  // empty at the fine level
  Shapes muscles, bones;

  // Warnings about meshes that lie inside others or are duplicates: contact
  // cannot separate them in a meaningful way.
  std::vector<std::string> warnings;
  double wall_ms = 0;
};

// Prepares a scene for the paper's contact. Precondition (CHECKed): the options
// are valid.
PaperScene PreparePaperScene(const PreparedScene& scene,
                             const PaperSceneOptions& options);

// Returns the contact of one pose, with bones in that pose and muscles at rest.
// Keeps pointers to both scenes.
GroupContact ContactInPose(const PreparedScene& scene,
                           const PaperScene& contact,
                           const ScenePose& pose);

}  // namespace musclewarp
