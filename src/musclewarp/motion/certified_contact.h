// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "musclewarp/certified_contact/clean_step.h"
#include "musclewarp/certified_contact/initial_separation.h"
#include "musclewarp/motion/prepared_scene.h"
#include "musclewarp/motion/scene_meshes.h"
#include "musclewarp/motion/solved_pose.h"

namespace musclewarp {

struct CertifiedContactOptions {
  InitialSeparationOptions separation;
  CleanStepOptions step;

  // How the coarse meshes make way (OneSidedRows): how many fine vertices of a
  // muscle they heed, for each of their own, and the weight of a row. What that
  // leaves, as the shape resists, is for single vertices. Weight 0: all of it.
  double samples_per_coarse_vertex = 3;
  double coarse_weight = 0.3;

  // The separated rest pose is relaxed in at most so many steps, until no
  // vertex moves by more than the tolerance in one. It has far to go, so that
  // its steps have more sweeps; one that leads to crossings is tried again with
  // more reach, from where it started.
  int max_rest_steps = 20;
  int rest_sweeps = 30;
  double max_rest_reach = 4;     // mm
  double rest_tolerance = 0.05;  // mm

  // A pose is reached in steps in which no body turns by more than this and no
  // point of a line moves by more than this. A step after which something still
  // crosses is halved, so many times.
  double max_turn = 2.5 * M_PI / 180;  // rad
  double max_move = 10;                // mm
  int max_halvings = 4;

  bool IsValid(std::string* error) const;
};

// The meshes of a scene as certified contact sees them, and the state without
// crossings that every motion starts from. Constant from then on.
struct CertifiedContact {
  CertifiedContactOptions options;
  // Muscles are taken in the order of their names: rounding must not see that
  // of the scene either. Of the first, the second, ... the index in the scene.
  std::vector<int> order;
  std::vector<ContactMesh> muscles;  // in that order
  // The fine vertices of each that the coarse meshes heed.
  std::vector<std::vector<int>> samples;
  std::vector<std::unique_ptr<TriangleBvh>> bones;  // at rest
  SceneState rest;
  double wall_ms = 0;
};

// Precondition (CHECKed): the options are valid.
CertifiedContact PrepareCertifiedContact(const PreparedScene& scene,
                                         const CertifiedContactOptions& options,
                                         const PreRotationOptions& pre_rotation,
                                         const GroupSolver& solver);

// How a pose was reached.
struct CertifiedWay {
  std::vector<SolverSummary> summaries;  // of the last step
  int steps = 0;                         // of the pose, those given up included
};

// Moves `state` to a pose. If it is clean it stays so, if there is a way.
CertifiedWay MoveCertified(const PreparedScene& scene,
                           const CertifiedContact& contact,
                           const ScenePose& pose,
                           const PreRotationOptions& pre_rotation,
                           const GroupSolver& solver,
                           SceneState* state);

}  // namespace musclewarp
