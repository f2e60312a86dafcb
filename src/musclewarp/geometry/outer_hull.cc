// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/outer_hull.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <utility>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/cgal/alpha_wrap.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {
namespace {

// The least distance of a wrap from the surface, as a fraction of alpha.
constexpr double kLeastDistance = 2.0 / 15;

#ifdef MUSCLEWARP_WITH_ALPHA_WRAP
TriangleSoup Wrap(const TriangleSoup& fine, double alpha, double distance) {
  return AlphaWrap(fine, alpha, distance);
}
#else
TriangleSoup Wrap(const TriangleSoup&, double, double) {
  throw InputError("outer hull",
                   "this build has no alpha wrap",
                   "build with MUSCLEWARP_WITH_ALPHA_WRAP=ON");
}
#endif

// A stray piece far from the muscle gets a wrap of its own, which cannot be
// part of the coarse mesh of one muscle.
TriangleSoup LargestComponent(TriangleSoup soup) {
  const Components components = ConnectedComponents(
      soup.triangles, EdgeUses(soup.triangles), /*max_uses=*/2);
  if (components.count == 1) return soup;
  TriangleSoup largest;
  double largest_volume = -INFINITY;
  for (int c = 0; c < components.count; ++c) {
    std::vector<bool> keep;
    for (const int label : components.label) keep.push_back(label == c);
    Triangles part = soup.triangles;
    KeepTriangles(keep, &part);
    const double volume = SignedVolume(soup.points, part);
    if (volume <= largest_volume) continue;
    largest_volume = volume;
    largest.triangles = std::move(part);
  }
  largest.points = std::move(soup.points);
  DropUnreferencedPoints(&largest);
  return largest;
}

}  // namespace

bool OuterHullOptions::IsValid(std::string* error) const {
  if (coarse_vertices < 20 || coarse_vertices > 5000) {
    *error = "OuterHullOptions::coarse_vertices is " +
             std::to_string(coarse_vertices) + ", allowed: 20 to 5000";
    return false;
  }
  if (!(relative_distance >= 0 && relative_distance <= 1)) {
    *error = "OuterHullOptions::relative_distance is " +
             std::to_string(relative_distance) + ", allowed: 0 to 1";
    return false;
  }
  if (!(count_tolerance > 0)) {
    *error = "OuterHullOptions::count_tolerance is " +
             std::to_string(count_tolerance) + ", allowed: above 0";
    return false;
  }
  if (max_wraps < 1) {
    *error = "OuterHullOptions::max_wraps is " + std::to_string(max_wraps) +
             ", allowed: 1 or above";
    return false;
  }
  return true;
}

TriangleSoup OuterHull(const TriangleSoup& fine,
                       const OuterHullOptions& options) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  // The edges of a wrap are about alpha long. So the number of triangles is
  // proportional to the area over alpha squared, and there are half as many
  // vertices.
  const double area = SurfaceArea(fine.points, fine.triangles);
  double alpha = std::sqrt(2 * area / options.coarse_vertices);
  const double distance = options.relative_distance * std::sqrt(area);
  TriangleSoup best;
  for (int wrap = 0; wrap < options.max_wraps; ++wrap) {
    TriangleSoup hull = LargestComponent(
        Wrap(fine, alpha, std::max(distance, kLeastDistance * alpha)));
    const double ratio =
        static_cast<double>(hull.points.rows()) / options.coarse_vertices;
    const auto miss = [&](const TriangleSoup& candidate) {
      return std::abs(candidate.points.rows() - options.coarse_vertices);
    };
    if (wrap == 0 || miss(hull) < miss(best)) best = std::move(hull);
    if (std::abs(ratio - 1) <= options.count_tolerance) break;
    alpha *= std::sqrt(ratio);
  }
  return best;
}

bool Encloses(const TriangleSoup& hull, const TriangleSoup& fine) {
  if (hull.triangles.rows() == 0) return false;
  const SearchableMesh outer(hull);
  // The inside of an open mesh is not well defined.
  if (!outer.winding().IsClosed()) return false;
  const MeshIntersection found = IntersectMeshes(outer, SearchableMesh(fine));
  // Unreferenced points are not part of the surface.
  const std::set<int> vertices(fine.triangles.data(),
                               fine.triangles.data() + fine.triangles.size());
  return found.triangle_pairs.empty() &&
         found.b_inside_a.size() == vertices.size();
}

}  // namespace musclewarp
