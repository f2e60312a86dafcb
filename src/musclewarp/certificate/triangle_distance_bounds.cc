// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certificate/triangle_distance_bounds.h"

#include <algorithm>
#include <cmath>

#include "musclewarp/cgal/triangle_intersection.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

// The unit roundoff of double: a result is off by this share of it at most.
constexpr double kRoundoff = 0x1p-53;

// mm. More than what underflow can change in a length: a square below 1e-308
// may have lost its digits.
constexpr double kUnderflow = 1e-150;

RowVector3d Edge(const Corners& t, int k) {
  return t.row((k + 1) % 3) - t.row(k);
}

// Two points, each on one of two triangles, that are as close as any found.
class ClosestPoints {
 public:
  ClosestPoints(const Corners& a, const Corners& b) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        TryCornerAndEdge(a.row(i), b, j, /*corner_is_of_a=*/true);
        TryCornerAndEdge(b.row(i), a, j, /*corner_is_of_a=*/false);
        TryEdges(a, i, b, j);
      }
    }
    TryCornersAndFace(a, b, /*corners_are_of_a=*/true);
    TryCornersAndFace(b, a, /*corners_are_of_a=*/false);
  }

  const RowVector3d& on_a() const { return on_a_; }
  const RowVector3d& on_b() const { return on_b_; }
  double distance() const { return std::sqrt(squared_distance_); }

 private:
  void Try(const RowVector3d& p, const RowVector3d& q, bool p_is_of_a) {
    const double squared_distance = (q - p).squaredNorm();
    if (!(squared_distance < squared_distance_)) return;
    squared_distance_ = squared_distance;
    on_a_ = p_is_of_a ? p : q;
    on_b_ = p_is_of_a ? q : p;
  }

  void TryCornerAndEdge(const RowVector3d& p,
                        const Corners& t,
                        int k,
                        bool corner_is_of_a) {
    const RowVector3d start = t.row(k), edge = Edge(t, k);
    const double along = (p - start).dot(edge);
    const double length = edge.squaredNorm();
    const double s = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    Try(p, start + s * edge, corner_is_of_a);
  }

  // Points within both edges; at their ends, TryCornerAndEdge has them.
  void TryEdges(const Corners& a, int i, const Corners& b, int j) {
    const RowVector3d u = Edge(a, i), v = Edge(b, j);
    const RowVector3d w = b.row(j) - a.row(i);
    const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
    const double uw = u.dot(w), vw = v.dot(w);
    const double det = uu * vv - uv * uv;
    const double s = (vv * uw - uv * vw) / det;
    const double t = (uv * uw - uu * vw) / det;
    if (!(det > 0) || !(s > 0 && s < 1) || !(t > 0 && t < 1)) return;
    Try(a.row(i) + s * u, b.row(j) + t * v, /*p_is_of_a=*/true);
  }

  // Corners whose foot is within the face; on its border, TryCornerAndEdge has
  // them.
  void TryCornersAndFace(const Corners& corners,
                         const Corners& face,
                         bool corners_are_of_a) {
    const RowVector3d u = face.row(1) - face.row(0);
    const RowVector3d v = face.row(2) - face.row(0);
    const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
    const double det = uu * vv - uv * uv;
    if (!(det > 0)) return;
    for (int k = 0; k < 3; ++k) {
      const RowVector3d w = corners.row(k) - face.row(0);
      const double uw = u.dot(w), vw = v.dot(w);
      const double s = (vv * uw - uv * vw) / det;
      const double t = (uu * vw - uv * uw) / det;
      if (!(s > 0 && t > 0 && s + t < 1)) continue;
      Try(corners.row(k), face.row(0) + s * u + t * v, corners_are_of_a);
    }
  }

  RowVector3d on_a_ = RowVector3d::Zero();
  RowVector3d on_b_ = RowVector3d::Zero();
  double squared_distance_ = std::numeric_limits<double>::infinity();
};

// Two triangles in coordinates relative to a corner of the first. These are
// small, and each is off by one rounding of the small number.
class TrianglePair {
 public:
  TrianglePair(const Corners& a, const Corners& b)
      : origin_(a.row(0)),
        a_(a.rowwise() - origin_),
        b_(b.rowwise() - origin_),
        extent_(a_.cwiseAbs().colwise().maxCoeff().cwiseMax(
            b_.cwiseAbs().colwise().maxCoeff())) {}

  // Returns a proved lower bound of the distance: the gap between the
  // projections of the triangles onto a line, or 0 if there is none.
  //
  // Let u be the unit roundoff, n the direction, and S the sum of |n_k| times
  // the largest |coordinate k| of a corner. A coordinate is off by u times its
  // size, and a sum of three products by 3 u S (to first order), so that a
  // projection is off by at most 4 u S. Of the difference of two of them 8 u S
  // may be such errors, and the two subtractions below add at most 2 u S each.
  // The 32 u S that are taken off are more than twice the sum. The length of n
  // is made longer and the quotient smaller by more than their roundings.
  double Separation(const RowVector3d& direction) const {
    const double largest = direction.cwiseAbs().maxCoeff();
    if (!(largest > 0)) return 0;
    const RowVector3d n = direction / largest;
    const RowVector3d on_a = a_ * n.transpose(), on_b = b_ * n.transpose();
    const double gap = std::max(on_b.minCoeff() - on_a.maxCoeff(),
                                on_a.minCoeff() - on_b.maxCoeff());
    const double size = n.cwiseAbs().dot(extent_);
    const double proved = gap - (32 * kRoundoff * size + kUnderflow);
    if (!(proved > 0)) return 0;
    const double length = n.norm() * (1 + 8 * kRoundoff);
    return proved / length * (1 - 4 * kRoundoff);
  }

  // Returns the largest separation along the normals of the faces.
  double SeparationByFaces() const {
    return std::max(Separation(AreaVector(a_)), Separation(AreaVector(b_)));
  }

  // Returns the largest separation along the common normals of two edges.
  double SeparationByEdges() const {
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        largest = std::max(largest, Separation(Edge(a_, i).cross(Edge(b_, j))));
      }
    }
    return largest;
  }

  // Returns the bounds; `at_least` is a lower bound that is known.
  //
  // A point start + s edge, or start + s u + t v, is off by at most 18 u E in
  // each coordinate, where E is the largest |coordinate|: by the rounding of
  // the coordinates, of the edges, of which none is longer than 2 E in a
  // coordinate, of the products and sums, and of s + t, which may exceed 1 by
  // 2 u. Only one of the two points is of the latter kind, so that both
  // together are less than 64 u E off.
  DistanceBounds Bounds(double at_least) const {
    const ClosestPoints closest(a_, b_);
    DistanceBounds bounds;
    bounds.at_most = closest.distance() * (1 + 8 * kRoundoff) +
                     (64 * kRoundoff * LargestCoordinate() + kUnderflow);
    bounds.place = origin_ + 0.5 * (closest.on_a() + closest.on_b());
    bounds.at_least =
        std::max(at_least, Separation(closest.on_b() - closest.on_a()));
    // The direction of points that are very close is not exact enough.
    if (bounds.at_most - bounds.at_least >
        256 * kRoundoff * LargestCoordinate()) {
      bounds.at_least = std::max(bounds.at_least, SeparationByEdges());
    }
    return bounds;
  }

 private:
  double LargestCoordinate() const { return extent_.maxCoeff(); }

  RowVector3d origin_;
  Corners a_, b_;
  RowVector3d extent_;  // the largest |x|, |y| and |z| of a corner
};

}  // namespace

DistanceBounds BoundDistance(const Corners& a, const Corners& b, double reach) {
  // One order of the two, so that the result does not depend on it.
  const bool is_swapped = std::lexicographical_compare(
      b.data(), b.data() + b.size(), a.data(), a.data() + a.size());
  const TrianglePair pair =
      is_swapped ? TrianglePair(b, a) : TrianglePair(a, b);
  const double by_faces = pair.SeparationByFaces();
  if (by_faces > reach) {
    DistanceBounds far_apart;
    far_apart.at_least = by_faces;
    return far_apart;
  }
  DistanceBounds bounds = pair.Bounds(by_faces);
  if (bounds.at_least == 0 && TrianglesIntersect(a, b)) bounds.at_most = 0;
  return bounds;
}

}  // namespace musclewarp
