// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/deformer/pose_walk.h"

#include <algorithm>
#include <utility>

namespace musclewarp {

PoseWalk::PoseWalk(Deformer* deformer) : deformer_(deformer), way_(1) {}

std::vector<int> PoseWalk::WayTo(int pose) const {
  std::vector<int> way = {pose};
  while (way.back() >= 0) {
    way.push_back(PoseBefore(deformer_->scene().scene, way.back()));
  }
  std::reverse(way.begin(), way.end());
  return way;
}

Frame PoseWalk::SolveNext(int pose) {
  const Start& start = way_.back();
  deformer_->set_state(start.state);
  Frame frame = deformer_->MoveTo(deformer_->scene().scene.poses[pose]);
  frame.reached_from = start.from;
  Start next = frame.IsUsable() ? Start{pose, pose, deformer_->state()}
                                : Start{pose, start.from, start.state};
  way_.push_back(std::move(next));
  return frame;
}

Frame PoseWalk::Solve(int pose) {
  const Scene& scene = deformer_->scene().scene;
  Frame frame;
  if (scene.is_motion) {
    frame = deformer_->MoveTo(scene.poses[pose]);
  } else if (scene.design.empty()) {
    frame = deformer_->SolveAlone(scene.poses[pose]);
  } else {
    const std::vector<int> way = WayTo(pose);
    size_t known = 1;
    while (known < way_.size() && known + 1 < way.size() &&
           way_[known].pose == way[known]) {
      ++known;
    }
    way_.resize(known);
    for (; known + 1 < way.size(); ++known) SolveNext(way[known]);
    frame = SolveNext(pose);
  }
  frame.index = pose;
  return frame;
}

}  // namespace musclewarp
