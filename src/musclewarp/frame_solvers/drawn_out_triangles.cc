// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/frame_solvers/drawn_out_triangles.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "musclewarp/base/option_check.h"
#include "musclewarp/mesh/mesh.h"
#include "musclewarp/mesh/triangle.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;
using Face = Mesh::FaceHandle;
using HalfEdge = Mesh::HalfedgeHandle;

// A triangle in both shapes.
struct TrianglePair {
  Corners rest, moved;

  double Stretch() const { return StretchOf(rest, moved); }
};

// The collapse of an edge onto the end of a half-edge.
struct Collapse {
  HalfEdge half_edge;
  double stretch = 0;    // the largest around the edge afterwards
  double deviation = 0;  // mm
};

class TriangleRemover {
 public:
  // Keeps references.
  TriangleRemover(const DrawnOutOptions& options,
                  const Points& moved,
                  const std::vector<bool>& locked,
                  Mesh* mesh)
      : options_(options), moved_(moved), locked_(locked), mesh_(*mesh) {
    mesh_.request_vertex_status();
    mesh_.request_edge_status();
    mesh_.request_face_status();
  }

  void Run() {
    // A collapse may make another one possible that was not before.
    constexpr int kMaxRounds = 10;
    for (int round = 0; round < kMaxRounds && Round(); ++round) {
    }
  }

 private:
  TrianglePair PairOf(HalfEdge h) const {
    TrianglePair pair;
    for (int k = 0; k < 3; ++k, h = mesh_.next_halfedge_handle(h)) {
      const Mesh::VertexHandle v = mesh_.from_vertex_handle(h);
      pair.rest.row(k) = Eigen::Map<const RowVector3d>(mesh_.point(v).data());
      pair.moved.row(k) = moved_.row(v.idx());
    }
    return pair;
  }

  double StretchOfFace(Face f) const {
    return PairOf(mesh_.halfedge_handle(f)).Stretch();
  }

  bool Round() {
    std::vector<std::pair<double, int>> drawn_out;  // (stretch, triangle)
    for (const Face f : mesh_.faces()) {
      const double stretch = StretchOfFace(f);
      if (stretch > options_.max_stretch)
        drawn_out.emplace_back(stretch, f.idx());
    }
    std::sort(drawn_out.rbegin(), drawn_out.rend());
    bool is_changed = false;
    for (const auto& [stretch, index] : drawn_out) {
      const Face f(index);
      if (mesh_.status(f).deleted() ||
          StretchOfFace(f) <= options_.max_stretch) {
        continue;
      }
      is_changed |= Remove(f);
    }
    return is_changed;
  }

  // Makes the best collapse of a corner of a triangle onto a neighbour. Returns
  // false if there is none.
  bool Remove(Face f) {
    std::optional<Collapse> best;
    for (const auto corner : mesh_.fv_range(f)) {
      for (const HalfEdge h : mesh_.voh_range(corner)) {
        const std::optional<Collapse> collapse = CollapseOf(h);
        if (!collapse) continue;
        if (!best || std::make_pair(collapse->stretch, collapse->deviation) <
                         std::make_pair(best->stretch, best->deviation)) {
          best = collapse;
        }
      }
    }
    if (best) mesh_.collapse(best->half_edge);
    return best.has_value();
  }

  // Returns the collapse onto the end of a half-edge, or nothing if it must not
  // be made.
  std::optional<Collapse> CollapseOf(HalfEdge h) const {
    if (locked_[mesh_.from_vertex_handle(h).idx()] ||
        locked_[mesh_.to_vertex_handle(h).idx()] || !mesh_.is_collapse_ok(h)) {
      return {};
    }
    const Face left = mesh_.face_handle(h);
    const Face right = mesh_.opposite_face_handle(h);
    const TrianglePair edge = PairOf(h);
    Collapse collapse = {h, options_.max_stretch, 0};
    double stretch_before = std::max(StretchOfFace(left), StretchOfFace(right));
    for (const HalfEdge out : mesh_.voh_range(mesh_.from_vertex_handle(h))) {
      const Face f = mesh_.face_handle(out);
      if (f == left || f == right) continue;
      const TrianglePair before = PairOf(out);
      TrianglePair after = before;
      after.rest.row(0) = edge.rest.row(1);
      after.moved.row(0) = edge.moved.row(1);
      if (!IsAllowed(before.rest, after.rest, &collapse.deviation) ||
          !IsAllowed(before.moved, after.moved, &collapse.deviation)) {
        return {};
      }
      stretch_before = std::max(stretch_before, before.Stretch());
      collapse.stretch = std::max(collapse.stretch, after.Stretch());
    }
    if (collapse.stretch >= stretch_before) return {};
    return collapse;
  }

  // Returns whether the first corner of a triangle may move; raises *deviation
  // to how far the surface moves.
  bool IsAllowed(const Corners& before,
                 const Corners& after,
                 double* deviation) const {
    constexpr double kMaxTurn = 0.4;  // cosine
    const double aspect = AspectOf(before);
    if (AspectOf(after) < std::min(aspect, kSliverAspect)) return false;
    if (aspect < kSliverAspect) return true;  // its normal is not reliable
    const RowVector3d normal = AreaVector(before).normalized();
    if (normal.dot(AreaVector(after).normalized()) < kMaxTurn) return false;
    const RowVector3d way = after.row(0) - before.row(0);
    *deviation = std::max(*deviation, std::abs(normal.dot(way)));
    return *deviation <= options_.max_deviation;
  }

  const DrawnOutOptions& options_;
  const Points& moved_;
  const std::vector<bool>& locked_;
  Mesh& mesh_;
};

// Returns the vertices that triangles of a mesh use.
std::vector<int> UsedVertices(const Mesh& mesh) {
  std::vector<int> used;
  for (const auto v : mesh.vertices()) used.push_back(v.idx());
  return used;
}

// Returns the triangles of a mesh between the vertices `kept`.
Triangles TrianglesBetween(const Mesh& mesh, const std::vector<int>& kept) {
  std::vector<int> place(mesh.n_vertices(), -1);
  for (size_t i = 0; i < kept.size(); ++i) place[kept[i]] = static_cast<int>(i);
  std::vector<std::array<int, 3>> left;
  for (const Face f : mesh.faces()) {
    std::array<int, 3>& corners = left.emplace_back();
    int corner = 0;
    for (const auto v : mesh.fv_range(f)) corners[corner++] = place[v.idx()];
  }
  Triangles triangles(left.size(), 3);
  for (size_t f = 0; f < left.size(); ++f) {
    for (int k = 0; k < 3; ++k) triangles(f, k) = left[f][k];
  }
  return triangles;
}

}  // namespace

bool DrawnOutOptions::IsValid(std::string* error) const {
  return OptionCheck("DrawnOutOptions", error)
      .IsAtLeast("max_stretch", max_stretch, 1)
      .IsAtLeast("max_deviation", max_deviation, 0)
      .is_valid();
}

std::vector<int> RemoveDrawnOutTriangles(const DrawnOutOptions& options,
                                         const Points& moved,
                                         const std::vector<bool>& locked,
                                         TriangleSoup* rest) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  CHECK_EQ(moved.rows(), rest->points.rows());
  CHECK_EQ(locked.size(), static_cast<size_t>(rest->points.rows()));
  Mesh mesh = MeshFromSoup(*rest);
  TriangleRemover(options, moved, locked, &mesh).Run();
  const std::vector<int> kept = UsedVertices(mesh);
  rest->triangles = TrianglesBetween(mesh, kept);
  rest->points = Points(rest->points(kept, Eigen::all));
  return kept;
}

}  // namespace musclewarp
