// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/sliver_removal.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "musclewarp/base/invalid_option.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/mesh.h"
#include "musclewarp/proximity/mesh_intersection.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Face = Mesh::FaceHandle;
using HalfEdge = Mesh::HalfedgeHandle;
using Vertex = Mesh::VertexHandle;

RowVector3d PointOf(const Mesh& mesh, Vertex v) {
  return Eigen::Map<const RowVector3d>(mesh.point(v).data());
}

struct Triangle {
  RowVector3d a, b, c;

  RowVector3d AreaVector() const { return (b - a).cross(c - a); }
  RowVector3d Normal() const { return AreaVector().stableNormalized(); }
  double LongestEdge() const {
    return std::sqrt(std::max(
        {(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  }
  double Height() const {
    const double longest = LongestEdge();
    return longest > 0 ? AreaVector().norm() / longest : 0;
  }
};

// The triangles around an edge, before and after a change.
struct Change {
  std::vector<Triangle> before, after;  // in pairs
  std::vector<Triangle> gone;
  double deviation = 0;  // of the surface, mm
};

class SliverRemover {
 public:
  // Edges with a vertex that is `locked` (#V) are left alone.
  SliverRemover(const SliverLimits& limits,
                const std::vector<bool>& locked,
                Mesh* mesh)
      : limits_(limits), locked_(locked), mesh_(*mesh) {
    double sum = 0;
    for (const auto edge : mesh_.edges()) sum += mesh_.calc_edge_length(edge);
    const double mean = sum / static_cast<double>(mesh_.n_edges());
    least_height_ = std::min(limits.height, limits.share_of_edges * mean);
    mesh_.request_vertex_status();
    mesh_.request_edge_status();
    mesh_.request_face_status();
  }

  SliverRemovals Run() {
    // A change may make another one possible that was not before.
    constexpr int kMaxRounds = 10;
    for (int round = 0; round < kMaxRounds && Round(); ++round) {
    }
    removals_.slivers_left = static_cast<int>(Slivers().size());
    return removals_;
  }

 private:
  // Returns a value below 1 for a sliver, smaller for a thinner one.
  double Thickness(const Triangle& t) const {
    const double height = t.Height();
    if (height == 0) return 0;
    return std::min(height / least_height_,
                    height / t.LongestEdge() / limits_.aspect);
  }

  bool IsLocked(HalfEdge h) const {
    return locked_[mesh_.from_vertex_handle(h).idx()] ||
           locked_[mesh_.to_vertex_handle(h).idx()];
  }

  double WorstThickness(const std::vector<Triangle>& triangles) const {
    double worst = 1;
    for (const Triangle& t : triangles) worst = std::min(worst, Thickness(t));
    return worst;
  }

  Triangle TriangleOf(HalfEdge h) const {
    return {
        PointOf(mesh_, mesh_.from_vertex_handle(h)),
        PointOf(mesh_, mesh_.to_vertex_handle(h)),
        PointOf(mesh_, mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)))};
  }
  Triangle TriangleOf(Face f) const {
    return TriangleOf(mesh_.halfedge_handle(f));
  }

  // Returns (thickness, triangle) of all slivers, the thinnest first.
  std::vector<std::pair<double, int>> Slivers() const {
    std::vector<std::pair<double, int>> slivers;
    for (const Face f : mesh_.faces()) {
      const double thickness = Thickness(TriangleOf(f));
      if (thickness < 1) slivers.emplace_back(thickness, f.idx());
    }
    std::sort(slivers.begin(), slivers.end());
    return slivers;
  }

  bool Round() {
    bool is_changed = false;
    for (const auto& [thickness, index] : Slivers()) {
      const Face f(index);
      if (mesh_.status(f).deleted() || Thickness(TriangleOf(f)) >= 1) continue;
      is_changed |= Remove(f);
    }
    return is_changed;
  }

  // Makes the best of the changes that remove a sliver. Returns false if there
  // is none.
  bool Remove(Face f) {
    double best = 0;
    std::function<void()> make;
    const auto offer = [&](const Change& change, std::function<void()> how) {
      const double gain = Gain(change);
      if (gain <= best) return;
      best = gain;
      make = [this, how = std::move(how), deviation = change.deviation] {
        how();
        removals_.largest_deviation =
            std::max(removals_.largest_deviation, deviation);
      };
    };
    for (const HalfEdge h : mesh_.fh_range(f)) {
      if (IsLocked(h)) continue;
      if (mesh_.is_collapse_ok(h)) {
        const RowVector3d from = PointOf(mesh_, mesh_.from_vertex_handle(h));
        const RowVector3d to = PointOf(mesh_, mesh_.to_vertex_handle(h));
        // The ends are tried first, so that points that stay keep their place.
        for (const RowVector3d& place :
             {to, from, RowVector3d((from + to) / 2)}) {
          offer(CollapseOf(h, place), [this, h, place] { Collapse(h, place); });
        }
      }
      if (mesh_.is_flip_ok(mesh_.edge_handle(h))) {
        offer(FlipOf(h), [this, h] { Flip(h); });
      }
    }
    if (best > 0) make();
    return best > 0;
  }

  // Returns how good a change is; zero if it must not be made.
  double Gain(const Change& change) const {
    constexpr double kMaxTurn = 0.7;  // cosine, of a triangle that stays
    if (change.deviation > limits_.max_deviation) return 0;
    const double thickness = WorstThickness(change.after);
    if (thickness <=
        std::min(WorstThickness(change.before), WorstThickness(change.gone))) {
      return 0;
    }
    for (size_t i = 0; i < change.before.size(); ++i) {
      if (Thickness(change.before[i]) >= 1 &&
          change.before[i].Normal().dot(change.after[i].Normal()) < kMaxTurn) {
        return 0;
      }
    }
    if (IsFolded(change)) return 0;
    return thickness < 1 ? thickness
                         : 2 - change.deviation / limits_.max_deviation;
  }

  // True if two neighbouring triangles fold more sharply than before.
  static bool IsFolded(const Change& change) {
    constexpr double kSharpFold = -0.5;  // cosine
    for (size_t i = 0; i < change.before.size(); ++i) {
      for (size_t j = 0; j < i; ++j) {
        const Triangle &s = change.after[i], &t = change.after[j];
        if (s.b != t.c && s.c != t.b) continue;
        const double before =
            change.before[i].Normal().dot(change.before[j].Normal());
        if (s.Normal().dot(t.Normal()) < std::min(before, kSharpFold)) {
          return true;
        }
      }
    }
    return false;
  }

  // Returns the change that moves both ends of the edge to `place`.
  Change CollapseOf(HalfEdge h, const RowVector3d& place) const {
    Change change;
    const HalfEdge opposite = mesh_.opposite_halfedge_handle(h);
    const Face left = mesh_.face_handle(h);
    const Face right = mesh_.face_handle(opposite);
    for (const Vertex end :
         {mesh_.from_vertex_handle(h), mesh_.to_vertex_handle(h)}) {
      for (const HalfEdge out : mesh_.voh_range(end)) {
        const Face f = mesh_.face_handle(out);
        if (f == left || f == right) continue;
        Triangle t = TriangleOf(out);
        change.before.push_back(t);
        // The normal of a lower triangle is not reliable.
        if (t.Height() > std::min(least_height_, limits_.max_deviation)) {
          change.deviation =
              std::max(change.deviation, std::abs(t.Normal().dot(place - t.a)));
        }
        t.a = place;
        change.after.push_back(t);
      }
    }
    change.gone = {TriangleOf(h), TriangleOf(opposite)};
    return change;
  }

  void Collapse(HalfEdge h, const RowVector3d& place) {
    const Vertex to = mesh_.to_vertex_handle(h);
    mesh_.collapse(h);
    mesh_.set_point(to, Mesh::Point(place.data()));
    ++removals_.collapsed_edges;
  }

  // Returns the change that replaces the edge by the other diagonal of its two
  // triangles. The thicker of them defines where the surface was.
  Change FlipOf(HalfEdge h) const {
    const Triangle left = TriangleOf(h);
    const Triangle right = TriangleOf(mesh_.opposite_halfedge_handle(h));
    const bool is_left = Thickness(left) > Thickness(right);
    const Triangle& thick = is_left ? left : right;
    const RowVector3d& beyond = is_left ? right.c : left.c;
    Change change;
    change.before = {thick, thick};
    change.after = {{left.c, right.c, left.b}, {left.c, left.a, right.c}};
    change.gone = {left, right};
    change.deviation = std::abs(thick.Normal().dot(beyond - thick.a));
    return change;
  }

  void Flip(HalfEdge h) {
    mesh_.flip(mesh_.edge_handle(h));
    ++removals_.flipped_edges;
  }

  const SliverLimits limits_;
  const std::vector<bool>& locked_;
  Mesh& mesh_;
  double least_height_;
  SliverRemovals removals_;
};

// Returns a mesh without its deleted triangles, but with all points. A garbage
// collection would change the order.
TriangleSoup LeftOf(const Mesh& mesh) {
  TriangleSoup soup;
  soup.points.resize(mesh.n_vertices(), 3);
  for (const auto v : mesh.all_vertices())
    soup.points.row(v.idx()) = PointOf(mesh, v);
  soup.triangles.resize(mesh.n_faces(), 3);
  int kept = 0;
  for (const Face f : mesh.faces()) {
    int corner = 0;
    for (const Vertex v : mesh.fv_range(f)) {
      soup.triangles(kept, corner++) = v.idx();
    }
    ++kept;
  }
  soup.triangles.conservativeResize(kept, 3);
  return soup;
}

// Returns the corners of all triangles that cross others.
std::vector<int> CrossingVertices(const TriangleSoup& soup) {
  std::vector<int> vertices;
  for (const auto& [f, g] : SelfIntersections(soup)) {
    for (int k = 0; k < 3; ++k) {
      vertices.push_back(soup.triangles(f, k));
      vertices.push_back(soup.triangles(g, k));
    }
  }
  return vertices;
}

}  // namespace

bool SliverLimits::IsValid(std::string* error) const {
  const auto fail = [error](const std::string& field,
                            double value,
                            const std::string& allowed) {
    return InvalidOption("SliverLimits::" + field, value, allowed, error);
  };
  if (!(aspect >= 0 && aspect <= 1)) return fail("aspect", aspect, "0 to 1");
  if (!(height >= 0)) return fail("height", height, "0 or above");
  if (!(share_of_edges >= 0)) {
    return fail("share_of_edges", share_of_edges, "0 or above");
  }
  if (!(max_deviation >= 0)) {
    return fail("max_deviation", max_deviation, "0 or above");
  }
  return true;
}

SliverRemovals RemoveSlivers(const SliverLimits& limits, TriangleSoup* soup) {
  std::string error;
  CHECK(limits.IsValid(&error)) << error;
  // Where sheets lie close to each other, even a small change may make them
  // cross. Vertices that then cross are locked, and all is tried again.
  constexpr int kMaxAttempts = 8;
  std::vector<bool> crosses(soup->points.rows(), false);
  std::vector<bool> locked(soup->points.rows(), false);
  if (limits.aspect == 0) return {};
  for (const int v : CrossingVertices(*soup)) crosses[v] = true;
  for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
    Mesh mesh = MeshFromSoup(*soup);
    const SliverRemovals removals = SliverRemover(limits, locked, &mesh).Run();
    if (removals.collapsed_edges + removals.flipped_edges == 0) return removals;
    TriangleSoup changed = LeftOf(mesh);
    bool is_worse = false;
    for (const int v : CrossingVertices(changed)) {
      if (crosses[v]) continue;
      is_worse = true;
      locked[v] = true;
    }
    if (is_worse) continue;
    DropUnreferencedPoints(&changed);
    *soup = std::move(changed);
    return removals;
  }
  return {};
}

}  // namespace musclewarp
