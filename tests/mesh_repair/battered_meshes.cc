// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "mesh_repair/battered_meshes.h"

#include <cmath>
#include <utility>
#include <vector>

namespace musclewarp {

int AddPoint(const Eigen::RowVector3d& point, TriangleSoup* soup) {
  soup->points.conservativeResize(soup->points.rows() + 1, 3);
  soup->points.bottomRows<1>() = point;
  return static_cast<int>(soup->points.rows()) - 1;
}

void AddTriangle(int a, int b, int c, TriangleSoup* soup) {
  soup->triangles.conservativeResize(soup->triangles.rows() + 1, 3);
  soup->triangles.bottomRows<1>() << a, b, c;
}

void AddSoup(const TriangleSoup& added, TriangleSoup* soup) {
  const int offset = static_cast<int>(soup->points.rows());
  for (int v = 0; v < added.points.rows(); ++v) {
    AddPoint(added.points.row(v), soup);
  }
  for (int f = 0; f < added.triangles.rows(); ++f) {
    AddTriangle(offset + added.triangles(f, 0),
                offset + added.triangles(f, 1),
                offset + added.triangles(f, 2),
                soup);
  }
}

Eigen::RowVector3d Middle(const TriangleSoup& soup, int f) {
  return (soup.points.row(soup.triangles(f, 0)) +
          soup.points.row(soup.triangles(f, 1)) +
          soup.points.row(soup.triangles(f, 2))) /
         3;
}

void CutOff(double z, TriangleSoup* soup) {
  int kept = 0;
  for (int f = 0; f < soup->triangles.rows(); ++f) {
    if (Middle(*soup, f).z() > z) continue;
    soup->triangles.row(kept++) = soup->triangles.row(f).eval();
  }
  soup->triangles.conservativeResize(kept, 3);
}

void TearOpen(double z, TriangleSoup* soup) {
  std::vector<int> copy(soup->points.rows(), -1);
  for (int f = 0; f < soup->triangles.rows(); ++f) {
    if (Middle(*soup, f).z() <= z) continue;
    for (int c = 0; c < 3; ++c) {
      const int v = soup->triangles(f, c);
      if (copy[v] < 0) copy[v] = AddPoint(soup->points.row(v).eval(), soup);
      soup->triangles(f, c) = copy[v];
    }
  }
}

int AddTJunction(int f, const Eigen::RowVector3d& beside, TriangleSoup* soup) {
  const int a = soup->triangles(f, 0);
  const int b = soup->triangles(f, 1);
  const int c = soup->triangles(f, 2);
  const int middle =
      AddPoint((soup->points.row(a) + soup->points.row(b)) / 2 + beside, soup);
  soup->triangles(f, 1) = middle;
  AddTriangle(middle, b, c, soup);
  return middle;
}

TriangleSoup MoebiusStrip() {
  constexpr int kSections = 20;
  TriangleSoup soup;
  for (int i = 0; i < kSections; ++i) {
    const double angle = 2 * M_PI * i / kSections;
    const Eigen::RowVector3d out(std::cos(angle), std::sin(angle), 0);
    const Eigen::RowVector3d across =
        std::cos(angle / 2) * out +
        std::sin(angle / 2) * Eigen::RowVector3d(0, 0, 1);
    AddPoint(10 * out + across, &soup);
    AddPoint(10 * out - across, &soup);
  }
  for (int i = 0; i < kSections; ++i) {
    const int a = 2 * i;
    int c = 2 * (i + 1) % (2 * kSections);
    int d = c + 1;
    if (c == 0) std::swap(c, d);
    AddTriangle(a, c, a + 1, &soup);
    AddTriangle(a + 1, c, d, &soup);
  }
  return soup;
}

}  // namespace musclewarp
