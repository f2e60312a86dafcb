// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/certified_contact/plane_owner.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene_pose.h"

namespace musclewarp {

// The vertices of a muscle that follow a bone, because it is attached there.
struct AttachedPoints {
  std::vector<int> vertices;  // in rising order
  Points positions;           // #vertices x 3, mm: where the bone has them
};

// A scene in contact at one moment: what a step starts from and ends in, what a
// motion goes back to where it is stuck, and what is kept of a frame for the
// next one. Whatever a later step is to know of an earlier one belongs here, so
// that it goes back with the state.
//
// Muscles are in the order of ContactScene.
struct ContactState {
  ScenePose pose;
  std::vector<Eigen::Matrix4d> bones_from_rest;  // the place of each bone

  // The coarse vertices of each muscle, N x 3, mm: as they would be without
  // contact, and as they make way for the planes. The next step keeps the
  // difference.
  std::vector<Points> free_coarse;
  std::vector<Points> coarse;

  // The fine vertices of each muscle where its coarse mesh has them, and where
  // they are, #V x 3, mm. The difference is the offset by which contact moves
  // single vertices.
  std::vector<Points> targets;
  std::vector<Points> points;

  // By muscle, or empty if nothing is attached.
  std::vector<AttachedPoints> held;

  // By muscle: the planes that the coarse mesh makes way for, or empty if the
  // coarse meshes were solved without. A plane is active if the coarse mesh has
  // its vertex on the wrong side.
  std::vector<OwnedHalfSpaces> planes;
};

}  // namespace musclewarp
