// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// CGAL's as-rigid-as-possible deformation of a surface mesh (Sorkine and Alexa
// 2007), to compare with. The package is under the GPL: benchmarks only.
class Arap {
 public:
  // A vertex that is held and where it goes.
  struct Handle {
    int vertex;
    Eigen::RowVector3d target;
  };

  // Factors the system of `mesh` for these handles.
  Arap(const TriangleSoup& mesh, const std::vector<Handle>& handles);
  ~Arap();

  // From rest; returns #V x 3.
  Points Deform(int iterations);

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace musclewarp
