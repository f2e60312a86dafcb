// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "support/meshes.h"

#include <array>
#include <cmath>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace musclewarp {

TriangleSoup UnitTetrahedron() {
  TriangleSoup soup;
  soup.points.resize(4, 3);
  soup.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
  soup.triangles.resize(4, 3);
  soup.triangles << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
  return soup;
}

TriangleSoup Box(double x, double y, double z) {
  TriangleSoup soup;
  soup.points.resize(8, 3);
  for (int corner = 0; corner < 8; ++corner) {
    soup.points.row(corner) << (corner & 1 ? x : -x) / 2,
        (corner & 2 ? y : -y) / 2, (corner & 4 ? z : -z) / 2;
  }
  soup.triangles.resize(12, 3);
  soup.triangles << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6,
      7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5;
  return soup;
}

TriangleSoup Icosphere(double radius, int levels) {
  const double t = (1 + std::sqrt(5.0)) / 2;
  std::vector<Eigen::RowVector3d> points = {{-1, t, 0},
                                            {1, t, 0},
                                            {-1, -t, 0},
                                            {1, -t, 0},
                                            {0, -1, t},
                                            {0, 1, t},
                                            {0, -1, -t},
                                            {0, 1, -t},
                                            {t, 0, -1},
                                            {t, 0, 1},
                                            {-t, 0, -1},
                                            {-t, 0, 1}};
  std::vector<Eigen::RowVector3i> faces = {
      {0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> midpoints;
    const auto midpoint = [&](int a, int b) {
      const auto [entry, is_new] =
          midpoints.try_emplace(std::minmax(a, b), points.size());
      if (is_new) points.push_back((points[a] + points[b]) / 2);
      return entry->second;
    };
    std::vector<Eigen::RowVector3i> finer;
    for (const auto& f : faces) {
      const int ab = midpoint(f[0], f[1]);
      const int bc = midpoint(f[1], f[2]);
      const int ca = midpoint(f[2], f[0]);
      finer.insert(
          finer.end(),
          {{f[0], ab, ca}, {f[1], bc, ab}, {f[2], ca, bc}, {ab, bc, ca}});
    }
    faces = std::move(finer);
  }
  TriangleSoup soup;
  soup.points.resize(points.size(), 3);
  soup.triangles.resize(faces.size(), 3);
  for (size_t i = 0; i < points.size(); ++i) {
    soup.points.row(i) = radius * points[i].normalized();
  }
  for (size_t i = 0; i < faces.size(); ++i) soup.triangles.row(i) = faces[i];
  return soup;
}

TriangleSoup Spindle(double radius, double half_length, int levels) {
  TriangleSoup soup = Icosphere(1, levels);
  soup.points.leftCols<2>() *= radius;
  soup.points.col(2) *= half_length;
  return soup;
}

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

Points RandomPoints(int count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  Points points(count, 3);
  for (double& x : points.reshaped()) x = coordinate(random);
  return points;
}

TriangleSoup Together(const TriangleSoup& a, const TriangleSoup& b) {
  TriangleSoup both;
  both.points.resize(a.points.rows() + b.points.rows(), 3);
  both.points << a.points, b.points;
  both.triangles.resize(a.triangles.rows() + b.triangles.rows(), 3);
  both.triangles << a.triangles,
      (b.triangles.array() + static_cast<int>(a.points.rows())).matrix();
  return both;
}

}  // namespace musclewarp
