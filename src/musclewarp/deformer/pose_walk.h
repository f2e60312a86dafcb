// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/deformer/deformer.h"
#include "musclewarp/frames/frame.h"
#include "musclewarp/frames/scene_state.h"

namespace musclewarp {

// Computes the frames of the poses of a scene, each from where it starts:
//
//   PoseWalk walk(&deformer);
//   for (int pose = 0; pose < num_poses; ++pose) Show(walk.Solve(pose));
//
// In a motion that is the current state of the deformer, so that poses have to
// be asked for in their order. Poses of a design (Scene::design) start from
// that of their tree, and may be asked for in any order, all or some: their
// frames are the same. What is on the way to a pose and has not been asked for
// just before is computed again, which few poses need in the order of the
// design. A posture whose frame is not usable spoils none that are reached from
// it: they start from where it started. Other poses start from rest.
class PoseWalk {
 public:
  // `deformer` is used by reference, and nothing else may move it meanwhile.
  explicit PoseWalk(Deformer* deformer);

  // Returns the frame of a pose by its number in the scene, with
  // Frame::reached_from if it is of a design.
  Frame Solve(int pose);

 private:
  // A pose on the way from rest, and the state from which those start that are
  // reached from it: its own or, if it is not usable, that of `from`.
  struct Start {
    int pose = -1;
    int from = -1;
    SceneState state;  // empty: rest
  };

  // Returns the poses from rest, which is -1, to a pose of the tree.
  std::vector<int> WayTo(int pose) const;
  Frame SolveNext(int pose);

  Deformer* deformer_;
  std::vector<Start> way_;
};

}  // namespace musclewarp
