// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/cgal/triangle_intersection.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/cgal/cgal_mesh.h"
#include "musclewarp/cgal/exact_predicates.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Point = CgalKernel::Point_3;
using Segment = CgalKernel::Segment_3;
using Triangle = CgalKernel::Triangle_3;

// The height of p over the plane through `origin` with a normal, of any length,
// and a bound on its rounding error. With e = 2^-53, each difference and each
// product has a relative error of e, and the sum adds 2 e, so that 5 e is a
// safe bound.
struct Height {
  Height(const RowVector3d& normal,
         const RowVector3d& origin,
         const RowVector3d& p) {
    const double x = normal[0] * (p[0] - origin[0]),
                 y = normal[1] * (p[1] - origin[1]),
                 z = normal[2] * (p[2] - origin[2]);
    value = x + y + z;
    error = 5 * 0x1p-53 * (std::abs(x) + std::abs(y) + std::abs(z)) +
            internal::kUnderflow;
  }
  double value, error;
};

// Returns true if a plane orthogonal to the connection of their centres surely
// separates the triangles. On a smooth surface this is so for nearly all
// triangles whose boxes overlap, though neither lies beside the plane of the
// other.
bool AreSurelyApart(const Corners& a, const Corners& b) {
  const RowVector3d up = b.colwise().sum() - a.colwise().sum();
  const RowVector3d origin = a.row(0);
  double highest_of_a = internal::kUnderflow;  // that of the origin
  for (const int i : {1, 2}) {
    const Height height(up, origin, a.row(i));
    highest_of_a = std::max(highest_of_a, height.value + height.error);
  }
  for (int i = 0; i < 3; ++i) {
    const Height height(up, origin, b.row(i));
    // The bounds are added with a relative error of e each.
    if (!(height.value - 2 * height.error > highest_of_a * (1 + 0x1p-50))) {
      return false;
    }
  }
  return true;
}

// Returns true if the triangles, whose corners `of_a` and `of_b` are the same
// point, surely have no other point in common: a plane through that corner
// separates the others.
bool AreSurelyApartBeyond(const Corners& a,
                          int of_a,
                          const Corners& b,
                          int of_b) {
  const RowVector3d up = b.colwise().sum() - a.colwise().sum();
  const RowVector3d origin = a.row(of_a);
  for (const int k : {1, 2}) {
    const Height below(up, origin, a.row((of_a + k) % 3));
    const Height above(up, origin, b.row((of_b + k) % 3));
    if (!(below.value < -below.error) || !(above.value > above.error)) {
      return false;
    }
  }
  return true;
}

// Returns true if the corners of b surely lie strictly on one side of the plane
// of a. If `common` is true, corners that are corners of a as well are left
// out.
//
// With e = 2^-53, the rounding error of a component of the normal is at most 4
// e times the sum of the absolute values of its products. The dot product adds
// 4 e, so that 10 e is a safe bound.
template <bool common>
bool IsSurelyBeside(const Corners& a, const Corners& b) {
  constexpr double kBound = 10 * 0x1p-53;
  const double ux = a(1, 0) - a(0, 0), uy = a(1, 1) - a(0, 1),
               uz = a(1, 2) - a(0, 2);
  const double vx = a(2, 0) - a(0, 0), vy = a(2, 1) - a(0, 1),
               vz = a(2, 2) - a(0, 2);
  const double nx = uy * vz - uz * vy, ny = uz * vx - ux * vz,
               nz = ux * vy - uy * vx;
  const double mx = std::abs(uy * vz) + std::abs(uz * vy),
               my = std::abs(uz * vx) + std::abs(ux * vz),
               mz = std::abs(ux * vy) + std::abs(uy * vx);
  int side = 0;
  for (int i = 0; i < 3; ++i) {
    if constexpr (common) {
      const auto is_same = [&](int j) {
        return a(j, 0) == b(i, 0) && a(j, 1) == b(i, 1) && a(j, 2) == b(i, 2);
      };
      if (is_same(0) || is_same(1) || is_same(2)) continue;
    }
    const double wx = b(i, 0) - a(0, 0), wy = b(i, 1) - a(0, 1),
                 wz = b(i, 2) - a(0, 2);
    const double height = nx * wx + ny * wy + nz * wz;
    const double bound =
        kBound * (mx * std::abs(wx) + my * std::abs(wy) + mz * std::abs(wz)) +
        internal::kUnderflow;
    if (!(std::abs(height) > bound)) return false;
    const int this_side = height > 0 ? 1 : -1;
    if (this_side == -side) return false;
    side = this_side;
  }
  return side != 0;
}

// The corners that span a triangle: three, or the two ends of a segment, or one
// point.
using Simplex = std::vector<Point>;

Simplex SimplexOf(const Corners& triangle) {
  Simplex points;
  for (int i = 0; i < 3; ++i) {
    points.emplace_back(triangle(i, 0), triangle(i, 1), triangle(i, 2));
  }
  if (!CGAL::collinear(points[0], points[1], points[2])) return points;
  std::sort(points.begin(), points.end());
  if (points.front() == points.back()) return {points.front()};
  return {points.front(), points.back()};
}

Segment SegmentOf(const Simplex& s) { return Segment(s[0], s[1]); }
Triangle TriangleOf(const Simplex& s) { return Triangle(s[0], s[1], s[2]); }

bool Intersect(const Simplex& a, const Simplex& b) {
  if (a.size() > b.size()) return Intersect(b, a);
  switch (10 * a.size() + b.size()) {
    case 11:
      return a[0] == b[0];
    case 12:
      return SegmentOf(b).has_on(a[0]);
    case 13:
      return TriangleOf(b).has_on(a[0]);
    case 22:
      return CGAL::do_intersect(SegmentOf(a), SegmentOf(b));
    case 23:
      return CGAL::do_intersect(SegmentOf(a), TriangleOf(b));
    default:
      return CGAL::do_intersect(TriangleOf(a), TriangleOf(b));
  }
}

Simplex Without(const Simplex& simplex, const Simplex& points) {
  Simplex rest;
  for (const Point& p : simplex) {
    if (std::find(points.begin(), points.end(), p) == points.end()) {
      rest.push_back(p);
    }
  }
  return rest;
}

// Returns true if the triangles (u, v, p) and (u, v, q) lie on each other.
bool AreFolded(const Point& u, const Point& v, const Point& p, const Point& q) {
  return CGAL::coplanar(u, v, p, q) &&
         CGAL::coplanar_orientation(u, v, p, q) == CGAL::POSITIVE;
}

bool IntersectBeyondCommon(const Simplex& a, const Simplex& b) {
  const Simplex only_a = Without(a, b);
  const Simplex only_b = Without(b, a);
  const Simplex common = Without(a, only_a);
  switch (common.size()) {
    case 0:
      return Intersect(a, b);
    case 1:
      // A common segment from the common corner leaves one of the triangles
      // first, through the side opposite to the corner, at a point of the
      // other.
      return (!only_a.empty() && Intersect(only_a, b)) ||
             (!only_b.empty() && Intersect(only_b, a));
    case 2:
      return only_a.size() == 1 && only_b.size() == 1 &&
             AreFolded(common[0], common[1], only_a[0], only_b[0]);
    default:
      return true;
  }
}

// How many pairs of a corner of a and a corner of b are the same point, and the
// first of these.
struct CommonCorners {
  CommonCorners(const Corners& a, const Corners& b) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        if (a(i, 0) != b(j, 0) || a.row(i) != b.row(j)) continue;
        if (count++ == 0) of_a = i, of_b = j;
      }
    }
  }
  int count = 0;
  int of_a = -1, of_b = -1;
};

enum class Answer { kNo, kYes, kTouching };

// Returns whether a segment and a triangle share a point, by the signs of
// volumes. The answer is kTouching, that is, open, if one of them is zero.
Answer SegmentMeetsTriangle(const RowVector3d& p,
                            const RowVector3d& q,
                            const Corners& t) {
  const RowVector3d a = t.row(0), b = t.row(1), c = t.row(2);
  const int side_p = Orientation(a, b, c, p);
  const int side_q = Orientation(a, b, c, q);
  if (side_p == side_q && side_p != 0) return Answer::kNo;
  const int ab = Orientation(p, q, a, b);
  const int bc = Orientation(p, q, b, c);
  const int ca = Orientation(p, q, c, a);
  if (std::min({ab, bc, ca}) < 0 && std::max({ab, bc, ca}) > 0) {
    return Answer::kNo;
  }
  const bool is_touching =
      side_p == 0 || side_q == 0 || ab == 0 || bc == 0 || ca == 0;
  return is_touching ? Answer::kTouching : Answer::kYes;
}

// Returns the same for the edges of `a` and the triangle b. If `corner` is
// given, only the edge opposite to it is tested.
Answer EdgesMeetTriangle(const Corners& a, const Corners& b, int corner = -1) {
  Answer all = Answer::kNo;
  for (int k = 0; k < 3; ++k) {
    if (corner >= 0 && k != corner) continue;
    const Answer one =
        SegmentMeetsTriangle(a.row((k + 1) % 3), a.row((k + 2) % 3), b);
    if (one == Answer::kYes) return one;
    if (one == Answer::kTouching) all = one;
  }
  return all;
}

// Combines the answers for the edges of both triangles. If no volume is zero,
// triangles intersect only if an edge of one goes through the other.
Answer Both(Answer of_a, Answer of_b) {
  if (of_a == Answer::kYes || of_b == Answer::kYes) return Answer::kYes;
  return of_a == Answer::kTouching ? of_a : of_b;
}

}  // namespace

bool TrianglesIntersect(const Corners& a, const Corners& b) {
  if (AreSurelyApart(a, b)) return false;
  if (IsSurelyBeside<false>(a, b) || IsSurelyBeside<false>(b, a)) return false;
  const Answer answer = Both(EdgesMeetTriangle(a, b), EdgesMeetTriangle(b, a));
  if (answer != Answer::kTouching) return answer == Answer::kYes;
  return Intersect(SimplexOf(a), SimplexOf(b));
}

bool TrianglesIntersect(const RowVector3d& a0,
                        const RowVector3d& a1,
                        const RowVector3d& a2,
                        const RowVector3d& b0,
                        const RowVector3d& b1,
                        const RowVector3d& b2) {
  Corners a, b;
  a << a0, a1, a2;
  b << b0, b1, b2;
  return TrianglesIntersect(a, b);
}

bool TrianglesIntersectBeyondCommon(const Corners& a, const Corners& b) {
  const CommonCorners common(a, b);
  if (common.count == 0) return TrianglesIntersect(a, b);
  const bool is_corner = common.count == 1;
  if (is_corner && AreSurelyApartBeyond(a, common.of_a, b, common.of_b)) {
    return false;
  }
  if (IsSurelyBeside<true>(a, b) || IsSurelyBeside<true>(b, a)) return false;
  if (is_corner) {
    const Answer answer = Both(EdgesMeetTriangle(a, b, common.of_a),
                               EdgesMeetTriangle(b, a, common.of_b));
    if (answer != Answer::kTouching) return answer == Answer::kYes;
  }
  return IntersectBeyondCommon(SimplexOf(a), SimplexOf(b));
}

bool IsOnTriangle(const RowVector3d& p, const Corners& triangle) {
  const RowVector3d a = triangle.row(0);
  const RowVector3d b = triangle.row(1);
  const RowVector3d c = triangle.row(2);
  if (Orientation(a, b, c, p) != 0) return false;
  return Intersect({Point(p[0], p[1], p[2])}, SimplexOf(triangle));
}

}  // namespace musclewarp
