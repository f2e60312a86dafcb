// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/fibres/muscle_ends.h"
#include "support/meshes.h"

namespace musclewarp {

// Bodies whose bones are balls of radius 8.
class BallBones {
 public:
  void Add(const std::string& body, const Eigen::RowVector3d& place) {
    TriangleSoup ball = Icosphere(8, 2);
    ball.points.rowwise() += place;
    trees_.push_back(
        std::make_unique<TriangleBvh>(ball.points, ball.triangles));
    for (BodySurface& known : bodies_) {
      if (known.body != body) continue;
      known.bones.push_back(trees_.back().get());
      return;
    }
    bodies_.push_back({body, {trees_.back().get()}});
  }
  const std::vector<BodySurface>& bodies() const { return bodies_; }

 private:
  std::vector<std::unique_ptr<TriangleBvh>> trees_;
  std::vector<BodySurface> bodies_;
};

}  // namespace musclewarp
