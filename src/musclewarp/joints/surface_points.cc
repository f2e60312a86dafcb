// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/surface_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "musclewarp/joints/point_search.h"
#include "musclewarp/mesh/box.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh/pieces.h"
#include "musclewarp/mesh_repair/orientation.h"
#include "musclewarp/mesh_repair/soup_cleaning.h"
#include "musclewarp/proximity/triangle_bvh.h"
#include "musclewarp/proximity/winding_number.h"

namespace musclewarp {
namespace {

bool Contains(const Box3& outer, const Box3& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (outer.lower[axis] > inner.lower[axis]) return false;
    if (outer.upper[axis] < inner.upper[axis]) return false;
  }
  return true;
}

// Returns true if a piece lies within one of the others. Pieces come in order
// of their area, the largest first, so that only those before it can hold it.
bool IsWithinAnother(const std::vector<TriangleSoup>& pieces, size_t piece) {
  const Box3 box = BoxOf(pieces[piece].points);
  for (size_t other = 0; other < piece; ++other) {
    if (!Contains(BoxOf(pieces[other].points), box)) continue;
    const TriangleBvh bvh(pieces[other].points, pieces[other].triangles);
    const WindingNumber winding(&bvh, pieces[other].triangles);
    if (winding.IsInside(pieces[piece].points.row(0))) return true;
  }
  return false;
}

// Returns the surface with its triangles oriented, without stray pieces and
// without those that lie within others.
TriangleSoup OuterSurface(TriangleSoup surface, double stray_fraction) {
  MergePoints(0, &surface);
  RemoveDegenerateTriangles(&surface);
  RemoveDuplicateTriangles(&surface.triangles);
  OrientConsistently(&surface);
  std::vector<TriangleSoup> pieces = PiecesOf(surface);
  std::vector<std::pair<double, size_t>> order;
  double area = 0;
  for (size_t piece = 0; piece < pieces.size(); ++piece) {
    order.push_back(
        {-SurfaceArea(pieces[piece].points, pieces[piece].triangles), piece});
    area -= order.back().first;
  }
  std::sort(order.begin(), order.end());
  std::vector<TriangleSoup> large;
  for (const auto& [negative_area, piece] : order) {
    if (-negative_area < stray_fraction * area) break;
    large.push_back(std::move(pieces[piece]));
  }
  std::vector<TriangleSoup> outer;
  for (size_t piece = 0; piece < large.size(); ++piece) {
    if (!IsWithinAnother(large, piece)) outer.push_back(large[piece]);
  }
  return Joined(outer);
}

// Returns points at equal steps of area along the list of triangles, placed
// within each triangle by a low-discrepancy sequence (the R2 sequence of
// Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018).
SurfacePoints SpreadByArea(const TriangleSoup& surface, double spacing) {
  constexpr double kFirstStep = 0.7548776662466927;
  constexpr double kSecondStep = 0.5698402909980532;
  SurfacePoints spread;
  const double area = SurfaceArea(surface.points, surface.triangles);
  const int count = std::lround(std::ceil(area / (spacing * spacing)));
  if (count == 0) return spread;
  spread.area = area / count;
  spread.points.resize(count, 3);
  spread.normals.resize(count, 3);
  double passed = 0;  // area of the triangles before
  int next = 0;
  for (int f = 0; f < surface.triangles.rows(); ++f) {
    const Eigen::RowVector3d a = surface.points.row(surface.triangles(f, 0));
    const Eigen::RowVector3d ab =
        surface.points.row(surface.triangles(f, 1)) - a;
    const Eigen::RowVector3d ac =
        surface.points.row(surface.triangles(f, 2)) - a;
    const Eigen::RowVector3d cross = ab.cross(ac);
    passed += cross.norm() / 2;
    for (; next < count && (next + 0.5) * spread.area < passed; ++next) {
      double u = std::fmod(0.5 + (next + 1) * kFirstStep, 1.0);
      double v = std::fmod(0.5 + (next + 1) * kSecondStep, 1.0);
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      spread.points.row(next) = a + u * ab + v * ac;
      spread.normals.row(next) = cross.normalized();
    }
  }
  // Rounding of the sum may leave out the last one.
  spread.points.conservativeResize(next, 3);
  spread.normals.conservativeResize(next, 3);
  return spread;
}

// Returns the mean of the normals around each point, without those that face
// the other way, as behind a thin wall.
Points AveragedNormals(const SurfacePoints& spread, double radius) {
  const PointSearch search(spread.points);
  Points averaged(spread.size(), 3);
#pragma omp parallel for schedule(dynamic, 256)
  for (int i = 0; i < spread.size(); ++i) {
    const Eigen::RowVector3d own = spread.normals.row(i);
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const int j : search.Within(spread.points.row(i), radius)) {
      if (spread.normals.row(j).dot(own) > 0) sum += spread.normals.row(j);
    }
    averaged.row(i) = sum.normalized();
  }
  return averaged;
}

}  // namespace

SurfacePoints SampleSurface(const TriangleSoup& surface,
                            const SurfaceSampling& sampling) {
  SurfacePoints spread = SpreadByArea(
      OuterSurface(surface, sampling.stray_fraction), sampling.spacing);
  return WithAveragedNormals(std::move(spread), sampling.normal_radius);
}

SurfacePoints WithAveragedNormals(SurfacePoints surface, double radius) {
  surface.normals = AveragedNormals(surface, radius);
  return surface;
}

SurfacePoints Subset(const SurfacePoints& all, const std::vector<int>& rows) {
  SurfacePoints some;
  some.area = all.area;
  some.points.resize(rows.size(), 3);
  some.normals.resize(rows.size(), 3);
  for (size_t i = 0; i < rows.size(); ++i) {
    some.points.row(i) = all.points.row(rows[i]);
    some.normals.row(i) = all.normals.row(rows[i]);
  }
  return some;
}

}  // namespace musclewarp
