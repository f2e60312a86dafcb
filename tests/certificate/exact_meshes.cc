// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "certificate/exact_meshes.h"

#include <CGAL/intersections.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace musclewarp {
namespace {

using Kernel = MeshKernel;
using Number = MeshNumber;
using Point = Kernel::Point_3;
using Triangle = Kernel::Triangle_3;

struct ExactMesh {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

ExactMesh ExactMeshOf(const TriangleSoup& soup) {
  ExactMesh mesh;
  for (const auto& p : soup.points.rowwise()) {
    mesh.points.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto& t : soup.triangles.rowwise()) {
    mesh.triangles.emplace_back(
        mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]);
  }
  return mesh;
}

bool HasDegenerate(const ExactMesh& mesh) {
  return std::any_of(mesh.triangles.begin(),
                     mesh.triangles.end(),
                     [](const Triangle& t) { return t.is_degenerate(); });
}

// Counts the triangles that a ray meets in their inside. Returns nothing if it
// meets an edge, or runs in the plane of a triangle.
std::optional<int> CrossingsOfRay(const ExactMesh& mesh,
                                  const Point& from,
                                  const Kernel::Vector_3& along) {
  int crossings = 0;
  const Point to = from + along;
  for (const Triangle& t : mesh.triangles) {
    std::array<CGAL::Orientation, 3> sides;
    for (int k = 0; k < 3; ++k) {
      sides[k] = CGAL::orientation(from, to, t.vertex(k), t.vertex(k + 1));
    }
    const bool is_left =
        std::count(sides.begin(), sides.end(), CGAL::LEFT_TURN);
    const bool is_right =
        std::count(sides.begin(), sides.end(), CGAL::RIGHT_TURN);
    if (is_left && is_right) continue;  // the line misses it
    if (std::count(sides.begin(), sides.end(), CGAL::COPLANAR) > 0) {
      return std::nullopt;
    }
    // In front of the point if the planes of both sides agree.
    const CGAL::Orientation side =
        CGAL::orientation(t.vertex(0), t.vertex(1), t.vertex(2), from);
    const Kernel::Vector_3 normal = CGAL::cross_product(
        t.vertex(1) - t.vertex(0), t.vertex(2) - t.vertex(0));
    const Number against = normal * along;
    crossings += side == CGAL::POSITIVE ? against < 0 : against > 0;
  }
  return crossings;
}

bool IsInside(const ExactMesh& mesh, const Point& point) {
  for (const Triangle& t : mesh.triangles) {
    if (t.has_on(point)) return false;
  }
  for (int k = 0;; ++k) {
    // Directions in no simple ratio to each other or to the meshes.
    const Kernel::Vector_3 along(1009 + 17 * k * k, 733 - 29 * k, 389 + 41 * k);
    const std::optional<int> crossings = CrossingsOfRay(mesh, point, along);
    if (crossings) return *crossings % 2 == 1;
  }
}

int CountInside(const ExactMesh& mesh, const std::vector<Point>& points) {
  CGAL::Bbox_3 box;
  for (const Point& point : mesh.points) box += point.bbox();
  return static_cast<int>(
      std::count_if(points.begin(), points.end(), [&](const Point& point) {
        return CGAL::do_overlap(box, point.bbox()) && IsInside(mesh, point);
      }));
}

Number SquaredDistance(const Triangle& a, const Triangle& b) {
  Number least = CGAL::squared_distance(a.vertex(0), b);
  for (int i = 0; i < 3; ++i) {
    least = std::min(least, CGAL::squared_distance(a.vertex(i), b));
    least = std::min(least, CGAL::squared_distance(b.vertex(i), a));
    const Kernel::Segment_3 edge(a.vertex(i), a.vertex(i + 1));
    for (int j = 0; j < 3; ++j) {
      least =
          std::min(least,
                   CGAL::squared_distance(
                       edge, Kernel::Segment_3(b.vertex(j), b.vertex(j + 1))));
    }
  }
  return least;
}

// The squared distance of two boxes, rounded.
double SquaredDistance(const CGAL::Bbox_3& a, const CGAL::Bbox_3& b) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double gap =
        std::max({0.0, a.min(k) - b.max(k), b.min(k) - a.max(k)});
    sum += gap * gap;
  }
  return sum;
}

// Looks at pairs in the order of the distances of their boxes, until no other
// one can be nearer.
Number SquaredDistance(const ExactMesh& a, const ExactMesh& b) {
  std::vector<std::tuple<double, const Triangle*, const Triangle*>> pairs;
  for (const Triangle& s : a.triangles) {
    for (const Triangle& t : b.triangles) {
      pairs.emplace_back(SquaredDistance(s.bbox(), t.bbox()), &s, &t);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  Number least =
      SquaredDistance(*std::get<1>(pairs[0]), *std::get<2>(pairs[0]));
  constexpr double kRounding = 1e-9;  // far more than that of the boxes
  for (const auto& [of_boxes, s, t] : pairs) {
    if (of_boxes * (1 - kRounding) > CGAL::to_double(least)) break;
    least = std::min(least, SquaredDistance(*s, *t));
  }
  return least;
}

}  // namespace

std::optional<ExactPair> CompareExactly(const TriangleSoup& a,
                                        const TriangleSoup& b) {
  const ExactMesh first = ExactMeshOf(a), second = ExactMeshOf(b);
  if (HasDegenerate(first) || HasDegenerate(second)) return std::nullopt;
  ExactPair pair;
  for (const Triangle& s : first.triangles) {
    for (const Triangle& t : second.triangles) {
      pair.triangle_pairs +=
          CGAL::do_overlap(s.bbox(), t.bbox()) && CGAL::do_intersect(s, t);
    }
  }
  pair.inside =
      CountInside(first, second.points) + CountInside(second, first.points);
  if (pair.triangle_pairs > 0) return pair;
  pair.squared_distance = SquaredDistance(first, second);
  return pair;
}

}  // namespace musclewarp
