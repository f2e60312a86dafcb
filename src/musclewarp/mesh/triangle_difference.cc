// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh/triangle_difference.h"

#include <algorithm>
#include <array>
#include <vector>

#include "musclewarp/mesh/connectivity.h"

namespace musclewarp {
namespace {

using Place = std::array<double, 3>;
using Corners3 = std::array<Place, 3>;  // ascending

Corners3 SortedCorners(const TriangleSoup& soup, Eigen::Index f) {
  Corners3 corners;
  for (int c = 0; c < 3; ++c) {
    const auto point = soup.points.row(soup.triangles(f, c));
    corners[c] = {point[0], point[1], point[2]};
  }
  std::sort(corners.begin(), corners.end());
  return corners;
}

}  // namespace

TriangleSoup TrianglesNotIn(const TriangleSoup& a, const TriangleSoup& b) {
  std::vector<Corners3> known;
  known.reserve(b.triangles.rows());
  for (Eigen::Index f = 0; f < b.triangles.rows(); ++f) {
    known.push_back(SortedCorners(b, f));
  }
  std::sort(known.begin(), known.end());
  std::vector<bool> keep(a.triangles.rows());
  for (Eigen::Index f = 0; f < a.triangles.rows(); ++f) {
    const Corners3 corners = SortedCorners(a, f);
    keep[f] = corners[0] != corners[1] && corners[1] != corners[2] &&
              !std::binary_search(known.begin(), known.end(), corners);
  }
  TriangleSoup difference = a;
  KeepTriangles(keep, &difference.triangles);
  DropUnreferencedPoints(&difference);
  return difference;
}

bool AreSame(const TriangleSoup& a, const TriangleSoup& b) {
  return a.points.rows() == b.points.rows() &&
         a.triangles.rows() == b.triangles.rows() && a.points == b.points &&
         a.triangles == b.triangles;
}

}  // namespace musclewarp
