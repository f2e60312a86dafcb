// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/exchange/crossing_places.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <tuple>
#include <utility>

#include "musclewarp/cgal/exact_predicates.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {
namespace {

using TrianglePairs = std::vector<std::pair<int, int>>;

// Where an edge of one mesh pierces a triangle of another. The two triangles at
// the edge, which both know the point by this, share it.
struct Piercing {
  int side;  // 0: an edge of a, 1: an edge of b that is another mesh
  int low, high;
  int triangle;

  bool operator<(const Piercing& other) const {
    return std::tie(side, low, high, triangle) <
           std::tie(other.side, other.low, other.high, other.triangle);
  }
};

// Collects the curve in which triangles of two meshes cross.
class CurveBuilder {
 public:
  CurveBuilder(const SearchableMesh& a, const SearchableMesh& b)
      : meshes_{&a, &b}, is_self_(&a == &b) {}

  void Add(int f, int g) {
    std::vector<int> ends;
    AddPiercings(0, f, g, &ends);
    AddPiercings(1, g, f, &ends);
    // More than two touch a corner or an edge; the farthest are the ends.
    double longest = 0;
    std::array<int, 2> segment = {0, 0};
    for (const int i : ends) {
      for (const int k : ends) {
        const double length = (points_[i] - points_[k]).squaredNorm();
        if (i >= k || length <= longest) continue;
        longest = length;
        segment = {i, k};
      }
    }
    if (longest > 0) segments_.push_back(segment);
  }

  SegmentSoup Curve() const {
    SegmentSoup curve;
    curve.points.resize(points_.size(), 3);
    for (size_t i = 0; i < points_.size(); ++i) {
      curve.points.row(i) = points_[i];
    }
    curve.segments.resize(segments_.size(), 2);
    for (size_t i = 0; i < segments_.size(); ++i) {
      curve.segments.row(i) << segments_[i][0], segments_[i][1];
    }
    return curve;
  }

 private:
  // Adds where edges of triangle f of mesh `side` pierce triangle g of the
  // other.
  void AddPiercings(int side, int f, int g, std::vector<int>* ends) {
    const SearchableMesh& mesh = *meshes_[side];
    const Corners& t = meshes_[1 - side]->bvh().corners(g);
    for (int k = 0; k < 3; ++k) {
      const int i = mesh.triangles()(f, k);
      const int j = mesh.triangles()(f, (k + 1) % 3);
      const int low = std::min(i, j), high = std::max(i, j);
      const Eigen::RowVector3d p = mesh.points().row(low);
      const Eigen::RowVector3d q = mesh.points().row(high);
      if (!Pierces(p, q, t)) continue;
      const auto [found, is_new] =
          numbers_.try_emplace(Piercing{is_self_ ? 0 : side, low, high, g},
                               static_cast<int>(points_.size()));
      if (is_new) points_.push_back(PiercedPoint(p, q, t));
      ends->push_back(found->second);
    }
  }

  // True if the segment pq and the triangle, which are not in one plane, share
  // a point.
  static bool Pierces(const Eigen::RowVector3d& p,
                      const Eigen::RowVector3d& q,
                      const Corners& t) {
    const int side_p = Orientation(t.row(0), t.row(1), t.row(2), p);
    const int side_q = Orientation(t.row(0), t.row(1), t.row(2), q);
    if (side_p == side_q) return false;
    int low = 0, high = 0;
    for (int k = 0; k < 3; ++k) {
      const int turn = Orientation(p, q, t.row(k), t.row((k + 1) % 3));
      low = std::min(low, turn);
      high = std::max(high, turn);
    }
    return low == 0 || high == 0;
  }

  static Eigen::RowVector3d PiercedPoint(const Eigen::RowVector3d& p,
                                         const Eigen::RowVector3d& q,
                                         const Corners& t) {
    const Eigen::RowVector3d normal = AreaVector(t);
    const double from = (p - t.row(0)).dot(normal);
    const double to = (q - t.row(0)).dot(normal);
    // Rounding may bring the two together, as the sides are exact.
    const double part =
        from == to ? 0.5 : std::clamp(from / (from - to), 0.0, 1.0);
    return p + part * (q - p);
  }

  std::array<const SearchableMesh*, 2> meshes_;
  bool is_self_;
  std::map<Piercing, int> numbers_;
  std::vector<Eigen::RowVector3d> points_;
  std::vector<std::array<int, 2>> segments_;
};

// The places of one pair of meshes, while they are collected.
class PlaceCollector {
 public:
  PlaceCollector(int number_a,
                 int number_b,
                 const SearchableMesh& a,
                 const SearchableMesh& b)
      : numbers_{number_a, number_b},
        a_(a),
        b_(b),
        triangles_of_a_(static_cast<int>(a.triangles().rows())),
        triangles_of_b_(static_cast<int>(b.triangles().rows())),
        vertices_of_a_(static_cast<int>(a.points().rows())),
        sets_(triangles_of_a_ + triangles_of_b_ + vertices_of_a_ +
              static_cast<int>(b.points().rows())) {}

  // Both meshes are the same.
  void JoinSelf(const TrianglePairs& pairs) {
    for (const auto& [f, g] : pairs) sets_.Join(f, g);
    for (const auto& [f, g] : pairs) AddPair(f, g);
  }

  void Join(const MeshIntersection& found) {
    std::vector<char> crosses(triangles_of_a_ + triangles_of_b_, 0);
    for (const auto& [f, g] : found.triangle_pairs) {
      sets_.Join(f, triangles_of_a_ + g);
      crosses[f] = crosses[triangles_of_a_ + g] = 1;
    }
    const int triangles = triangles_of_a_ + triangles_of_b_;
    JoinInside(a_, found.a_inside_b, crosses, 0, triangles);
    JoinInside(b_,
               found.b_inside_a,
               crosses,
               triangles_of_a_,
               triangles + vertices_of_a_);
    for (const auto& [f, g] : found.triangle_pairs) {
      AddPair(f, triangles_of_a_ + g);
    }
    AddInside(a_, b_, found.a_inside_b, triangles);
    AddInside(b_, a_, found.b_inside_a, triangles + vertices_of_a_);
  }

  std::vector<CrossingPlace> Places() {
    std::vector<CrossingPlace> places;
    for (auto& [root, group] : groups_) {
      CrossingPlace& place = group.place;
      const bool is_self = numbers_[0] == numbers_[1];
      CurveBuilder curve(a_, b_);
      for (const auto& [f, other] : group.pairs) {
        place.triangles_of_a.push_back(f);
        const int g = is_self ? other : other - triangles_of_a_;
        (is_self ? place.triangles_of_a : place.triangles_of_b).push_back(g);
        curve.Add(f, g);
      }
      place.curve = curve.Curve();
      for (auto* list : {&place.triangles_of_a, &place.triangles_of_b}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
      }
      if (place.vertices_inside == 0) place.point = Middle(place);
      places.push_back(std::move(place));
    }
    return places;
  }

 private:
  struct Group {
    CrossingPlace place;
    TrianglePairs pairs;  // the second by its number in the sets
  };

  // Joins vertices inside along edges, and with the crossing triangles around
  // them. `triangles` and `vertices`: where those of the mesh begin in the
  // sets.
  void JoinInside(const SearchableMesh& mesh,
                  const std::vector<int>& inside,
                  const std::vector<char>& crosses,
                  int triangles,
                  int vertices) {
    std::vector<char> is_inside(mesh.points().rows(), 0);
    for (const int v : inside) is_inside[v] = 1;
    for (Eigen::Index f = 0; f < mesh.triangles().rows(); ++f) {
      const int node = triangles + static_cast<int>(f);
      for (int k = 0; k < 3; ++k) {
        const int v = mesh.triangles()(f, k);
        const int w = mesh.triangles()(f, (k + 1) % 3);
        if (!is_inside[v]) continue;
        if (is_inside[w]) sets_.Join(vertices + v, vertices + w);
        if (crosses[node]) sets_.Join(vertices + v, node);
      }
    }
  }

  Group& GroupOf(int node) {
    Group& group = groups_[sets_.Find(node)];
    group.place.a = numbers_[0];
    group.place.b = numbers_[1];
    return group;
  }

  void AddPair(int f, int g) { GroupOf(f).pairs.emplace_back(f, g); }

  void AddInside(const SearchableMesh& mesh,
                 const SearchableMesh& other,
                 const std::vector<int>& inside,
                 int vertices) {
    for (const int v : inside) {
      CrossingPlace& place = GroupOf(vertices + v).place;
      const Eigen::RowVector3d point = mesh.points().row(v);
      const double depth = other.bvh().ClosestPoint(point).distance;
      if (place.vertices_inside++ == 0 || depth > place.depth_mm) {
        place.depth_mm = depth;
        place.point = point;
      }
    }
  }

  Eigen::RowVector3d Middle(const CrossingPlace& place) const {
    if (place.curve.points.rows() > 0)
      return place.curve.points.colwise().mean();
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const int f : place.triangles_of_a) {
      sum += a_.bvh().corners(f).colwise().mean();
    }
    return sum / static_cast<double>(place.triangles_of_a.size());
  }

  std::array<int, 2> numbers_;
  const SearchableMesh& a_;
  const SearchableMesh& b_;
  int triangles_of_a_, triangles_of_b_, vertices_of_a_;
  // Triangles of a and of b, then vertices of a and of b.
  DisjointSets sets_;
  std::map<int, Group> groups_;
};

}  // namespace

std::vector<CrossingPlace> FindCrossingPlaces(
    const std::vector<NamedMesh>& muscles,
    const std::vector<NamedMesh>& bones) {
  std::vector<NamedMesh> meshes = muscles;
  meshes.insert(meshes.end(), bones.begin(), bones.end());
  std::vector<CrossingPlace> places;
  const auto append = [&](std::vector<CrossingPlace> more) {
    std::move(more.begin(), more.end(), std::back_inserter(places));
  };
  for (size_t i = 0; i < muscles.size(); ++i) {
    const SearchableMesh& a = *meshes[i].mesh;
    const int number = static_cast<int>(i);
    const TrianglePairs self = SelfIntersections(a.bvh());
    if (!self.empty()) {
      PlaceCollector collector(number, number, a, a);
      collector.JoinSelf(self);
      append(collector.Places());
    }
    for (size_t k = i + 1; k < meshes.size(); ++k) {
      const SearchableMesh& b = *meshes[k].mesh;
      const MeshIntersection found = IntersectMeshes(a, b);
      if (found.IsEmpty()) continue;
      PlaceCollector collector(number, static_cast<int>(k), a, b);
      collector.Join(found);
      append(collector.Places());
    }
  }
  return places;
}

double CurveLength(const SegmentSoup& curve) {
  double length = 0;
  for (Eigen::Index i = 0; i < curve.segments.rows(); ++i) {
    length += (curve.points.row(curve.segments(i, 0)) -
               curve.points.row(curve.segments(i, 1)))
                  .norm();
  }
  return length;
}

}  // namespace musclewarp
