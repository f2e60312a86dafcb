// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "contact/contact_cases.h"

#include <array>
#include <map>
#include <vector>

namespace musclewarp {

TriangleSoup LatticeBox(int nx, int ny, int nz) {
  const std::array<int, 3> n = {nx, ny, nz};
  std::map<std::array<int, 3>, int> index;
  std::vector<std::array<int, 3>> triangles;
  const auto point = [&](const std::array<int, 3>& p) {
    return index.emplace(p, static_cast<int>(index.size())).first->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (const bool is_upper : {false, true}) {
      for (int i = 0; i < n[u]; ++i) {
        for (int j = 0; j < n[v]; ++j) {
          std::array<int, 4> corner;
          for (int c = 0; c < 4; ++c) {
            std::array<int, 3> p;
            p[axis] = is_upper ? n[axis] : 0;
            p[u] = i + (c == 1 || c == 2);
            p[v] = j + (c >= 2);
            corner[c] = point(p);
          }
          if (!is_upper) std::swap(corner[1], corner[3]);
          triangles.push_back({corner[0], corner[1], corner[2]});
          triangles.push_back({corner[0], corner[2], corner[3]});
        }
      }
    }
  }
  TriangleSoup soup;
  soup.points.resize(index.size(), 3);
  for (const auto& [p, i] : index) soup.points.row(i) << p[0], p[1], p[2];
  soup.triangles.resize(triangles.size(), 3);
  for (size_t f = 0; f < triangles.size(); ++f) {
    soup.triangles.row(f) << triangles[f][0], triangles[f][1], triangles[f][2];
  }
  return soup;
}

}  // namespace musclewarp
