// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "musclewarp/certified_contact/kept_planes.h"
#include "musclewarp/certified_contact/plane_owner.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/scene/scene_pose.h"

namespace musclewarp {

// The vertices of a muscle that are attached to bones, and their prescribed
// positions.
struct AttachedPoints {
  std::vector<int> vertices;  // in rising order
  Points positions;           // #vertices x 3, mm
};

// The complete state of a scene in contact: the start and the result of a step,
// the target of a backtrack, and the start of the next frame. Anything that a
// step passes on to later steps belongs here, so that backtracking restores it.
//
// Muscles are in the order of ContactScene.
struct ContactState {
  ScenePose pose;
  std::vector<Eigen::Matrix4d> bones_from_rest;  // one transform per bone

  // The coarse vertices of each muscle, N x 3, mm: the solution without
  // contact, and the one with contact rows. The next step is predicted with the
  // same difference.
  std::vector<Points> free_coarse;
  std::vector<Points> coarse;

  // The fine vertices of each muscle, #V x 3, mm: as interpolated from its
  // coarse mesh, and their actual positions. The difference is the offset of
  // each vertex by contact.
  std::vector<Points> targets;
  std::vector<Points> points;

  // By muscle; empty without attachments, as before the rest pose is known.
  std::vector<AttachedPoints> held;

  // By muscle: the planes of the contact rows in the coarse solve; empty if the
  // coarse meshes were solved without any. A plane is active if the target of
  // its vertex lies on the wrong side.
  std::vector<OwnedHalfSpaces> planes;

  // By muscle: the volume that its neighbours withhold, mm^3, added up over the
  // steps in which free vertices could not make up for it. The pressure of the
  // muscle counts it as missing, until they yield. Empty: none.
  std::vector<double> withheld;

  // The planes that bones keep against muscles. Null in the rest pose, and
  // after a pose that was reached without contact: the next step finds them
  // anew. Shared by the copies of a state.
  std::shared_ptr<const KeptBonePlanes> bone_planes;
};

}  // namespace musclewarp
