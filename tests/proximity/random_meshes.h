// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <random>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/triangle_bvh.h"

namespace musclewarp {

inline Eigen::RowVector3d RandomPoint(double size, std::mt19937* random) {
  std::uniform_real_distribution<double> coordinate(-size, size);
  Eigen::RowVector3d p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = coordinate(*random);
  return p;
}

// Triangles of points of a grid with the coordinates 0 .. cells: most are in
// special position, many have no area.
inline Corners RandomGridTriangle(int cells, std::mt19937* random) {
  std::uniform_int_distribution<int> coordinate(0, cells);
  Corners triangle;
  for (int i = 0; i < 9; ++i) triangle.data()[i] = coordinate(*random);
  return triangle;
}

// `count` separate triangles of the given size in a cube of side 2.
inline TriangleSoup RandomSoup(int count, double size, std::mt19937* random) {
  TriangleSoup soup;
  soup.points.resize(3 * count, 3);
  soup.triangles.resize(count, 3);
  for (int f = 0; f < count; ++f) {
    const Eigen::RowVector3d center = RandomPoint(1, random);
    for (int corner = 0; corner < 3; ++corner) {
      soup.points.row(3 * f + corner) = center + RandomPoint(size, random);
      soup.triangles(f, corner) = 3 * f + corner;
    }
  }
  return soup;
}

}  // namespace musclewarp
