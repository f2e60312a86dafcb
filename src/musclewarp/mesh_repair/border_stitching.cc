// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/border_stitching.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <vector>

namespace musclewarp {
namespace {

using CornerPoints = std::array<int, 3>;

// A consistently oriented soup that is being stitched: every directed edge has
// at most one triangle, and on a border the opposite edge has none.
class Borders {
 public:
  explicit Borders(const TriangleSoup& soup);

  // Returns the border edges in ascending order, each in the direction in which
  // its triangle runs. They are valid until a triangle changes.
  const std::vector<std::array<int, 2>>& Edges();

  bool IsBorderEdge(int a, int b) const {
    return HasDirectedEdge(a, b) && !HasDirectedEdge(b, a);
  }

  // True if a border edge starts in v.
  bool IsOnBorder(int v) const;

  // Replaces point `from` by point `to`. Returns false and does nothing if an
  // edge would get a third triangle or a triangle would collapse.
  bool Merge(int from, int to);

  // Splits the border edge a b of a triangle at point v. Returns false and does
  // nothing if an edge would get a third triangle.
  bool Insert(int v, int a, int b);

  Triangles ToTriangles() const;

 private:
  static uint64_t Key(int a, int b) {
    return static_cast<uint64_t>(a) << 32 | static_cast<uint32_t>(b);
  }
  bool HasDirectedEdge(int a, int b) const {
    return triangle_of_edge_.count(Key(a, b)) > 0;
  }
  void Link(int f);
  void Unlink(int f);

  std::vector<CornerPoints> triangles_;
  std::vector<std::vector<int>> triangles_of_point_;
  std::unordered_map<uint64_t, int> triangle_of_edge_;

  // Found when they are asked for, and forgotten when a triangle changes.
  std::vector<std::array<int, 2>> edges_;
  bool are_edges_known_ = false;
};

Borders::Borders(const TriangleSoup& soup)
    : triangles_of_point_(soup.points.rows()) {
  triangle_of_edge_.reserve(soup.triangles.size());
  for (int f = 0; f < soup.triangles.rows(); ++f) {
    triangles_.push_back(
        {soup.triangles(f, 0), soup.triangles(f, 1), soup.triangles(f, 2)});
    Link(f);
  }
}

void Borders::Link(int f) {
  are_edges_known_ = false;
  for (int c = 0; c < 3; ++c) {
    const int a = triangles_[f][c];
    triangles_of_point_[a].push_back(f);
    const uint64_t key = Key(a, triangles_[f][(c + 1) % 3]);
    CHECK(triangle_of_edge_.emplace(key, f).second)
        << "two triangles run the same way along an edge of triangle " << f;
  }
}

void Borders::Unlink(int f) {
  are_edges_known_ = false;
  for (int c = 0; c < 3; ++c) {
    const int a = triangles_[f][c];
    auto& around = triangles_of_point_[a];
    around.erase(std::find(around.begin(), around.end(), f));
    triangle_of_edge_.erase(Key(a, triangles_[f][(c + 1) % 3]));
  }
}

const std::vector<std::array<int, 2>>& Borders::Edges() {
  if (are_edges_known_) return edges_;
  edges_.clear();
  for (const CornerPoints& corners : triangles_) {
    for (int c = 0; c < 3; ++c) {
      const int a = corners[c];
      const int b = corners[(c + 1) % 3];
      if (!HasDirectedEdge(b, a)) edges_.push_back({a, b});
    }
  }
  std::sort(edges_.begin(), edges_.end());
  are_edges_known_ = true;
  return edges_;
}

bool Borders::IsOnBorder(int v) const {
  for (const int f : triangles_of_point_[v]) {
    const CornerPoints& corners = triangles_[f];
    const int c =
        std::find(corners.begin(), corners.end(), v) - corners.begin();
    if (!HasDirectedEdge(corners[(c + 1) % 3], v)) return true;
  }
  return false;
}

bool Borders::Merge(int from, int to) {
  for (const int f : triangles_of_point_[from]) {
    const CornerPoints& corners = triangles_[f];
    const int c =
        std::find(corners.begin(), corners.end(), from) - corners.begin();
    const int next = corners[(c + 1) % 3];
    const int last = corners[(c + 2) % 3];
    if (next == to || last == to) return false;
    if (HasDirectedEdge(to, next) || HasDirectedEdge(last, to)) return false;
    // Two triangles back to back would enclose nothing.
    const auto opposite = triangle_of_edge_.find(Key(last, next));
    if (opposite != triangle_of_edge_.end()) {
      const CornerPoints& other = triangles_[opposite->second];
      if (std::find(other.begin(), other.end(), to) != other.end()) {
        return false;
      }
    }
  }
  const std::vector<int> moved = triangles_of_point_[from];
  for (const int f : moved) {
    Unlink(f);
    std::replace(triangles_[f].begin(), triangles_[f].end(), from, to);
    Link(f);
  }
  return true;
}

bool Borders::Insert(int v, int a, int b) {
  if (!IsBorderEdge(a, b)) return false;
  const int f = triangle_of_edge_.at(Key(a, b));
  const CornerPoints corners = triangles_[f];
  int c = corners[0];
  for (const int corner : corners) {
    if (corner != a && corner != b) c = corner;
  }
  if (v == a || v == b || v == c) return false;
  if (HasDirectedEdge(a, v) || HasDirectedEdge(v, b) || HasDirectedEdge(v, c) ||
      HasDirectedEdge(c, v)) {
    return false;
  }
  Unlink(f);
  CornerPoints first = corners;
  std::replace(first.begin(), first.end(), b, v);
  CornerPoints second = corners;
  std::replace(second.begin(), second.end(), a, v);
  triangles_[f] = first;
  Link(f);
  triangles_.push_back(second);
  Link(static_cast<int>(triangles_.size()) - 1);
  return true;
}

Triangles Borders::ToTriangles() const {
  Triangles triangles(triangles_.size(), 3);
  for (size_t f = 0; f < triangles_.size(); ++f) {
    triangles.row(f) << triangles_[f][0], triangles_[f][1], triangles_[f][2];
  }
  return triangles;
}

struct Candidate {
  double distance;
  int v;
  int a;
  int b;  // v belongs onto edge a b, or onto a if b < 0
};

bool operator<(const Candidate& x, const Candidate& y) {
  return std::tie(x.distance, x.v, x.a, x.b) <
         std::tie(y.distance, y.v, y.a, y.b);
}

// Returns the border points in the order of their first coordinates.
std::vector<int> PointsByX(const std::vector<std::array<int, 2>>& edges,
                           const Points& points) {
  std::vector<int> sorted;
  for (const auto& [a, b] : edges) sorted.insert(sorted.end(), {a, b});
  std::sort(sorted.begin(), sorted.end(), [&](int a, int b) {
    return points(a, 0) != points(b, 0) ? points(a, 0) < points(b, 0) : a < b;
  });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

std::vector<Candidate> PointsBesidePoints(const std::vector<int>& by_x,
                                          const Points& points,
                                          double tolerance) {
  std::vector<Candidate> candidates;
  for (size_t i = 0; i < by_x.size(); ++i) {
    for (size_t j = i + 1; j < by_x.size(); ++j) {
      if (points(by_x[j], 0) - points(by_x[i], 0) > tolerance) break;
      const double distance =
          (points.row(by_x[j]) - points.row(by_x[i])).norm();
      if (distance > tolerance) continue;
      const auto [low, high] = std::minmax({by_x[i], by_x[j]});
      candidates.push_back({distance, high, low, -1});
    }
  }
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

std::vector<Candidate> PointsBesideEdges(
    const std::vector<std::array<int, 2>>& edges,
    const std::vector<int>& by_x,
    const Points& points,
    double tolerance) {
  std::vector<Candidate> candidates;
  for (const auto& [a, b] : edges) {
    const Eigen::RowVector3d start = points.row(a);
    const Eigen::RowVector3d along = points.row(b) - points.row(a);
    const double x_min = std::min(points(a, 0), points(b, 0)) - tolerance;
    const double x_max = std::max(points(a, 0), points(b, 0)) + tolerance;
    auto v = std::lower_bound(
        by_x.begin(), by_x.end(), x_min, [&](int point, double x) {
          return points(point, 0) < x;
        });
    for (; v != by_x.end() && points(*v, 0) <= x_max; ++v) {
      if (*v == a || *v == b) continue;
      const Eigen::RowVector3d arm = points.row(*v) - start;
      const double t = arm.dot(along) / along.squaredNorm();
      if (!(t > 0 && t < 1)) continue;
      const double distance = (arm - t * along).norm();
      if (distance <= tolerance) candidates.push_back({distance, *v, a, b});
    }
  }
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

// Merges border points with border points, closest first.
void MergeBorderPoints(double tolerance,
                       const Points& points,
                       Borders* borders,
                       Stitches* stitches) {
  const auto by_x = PointsByX(borders->Edges(), points);
  for (const Candidate& candidate :
       PointsBesidePoints(by_x, points, tolerance)) {
    if (!borders->IsOnBorder(candidate.v) ||
        !borders->IsOnBorder(candidate.a) ||
        !borders->Merge(candidate.v, candidate.a)) {
      continue;
    }
    ++stitches->merged_points;
    stitches->longest = std::max(stitches->longest, candidate.distance);
  }
}

// Splits border edges at border points beside them, closest first.
void InsertBorderPoints(double tolerance,
                        const Points& points,
                        Borders* borders,
                        Stitches* stitches) {
  const auto& edges = borders->Edges();
  const auto by_x = PointsByX(edges, points);
  for (const Candidate& candidate :
       PointsBesideEdges(edges, by_x, points, tolerance)) {
    if (!borders->IsOnBorder(candidate.v) ||
        !borders->Insert(candidate.v, candidate.a, candidate.b)) {
      continue;
    }
    ++stitches->inserted_points;
    stitches->longest = std::max(stitches->longest, candidate.distance);
  }
}

}  // namespace

Stitches StitchBorders(double tolerance, TriangleSoup* soup) {
  // For points beside edges the tolerance grows in steps, given as shares of
  // the whole. Points beside points have all of it from the start: an edge that
  // is split close to one of its ends leaves a needle, and needles cross each
  // other.
  constexpr double kSteps[] = {0, 1e-3, 0.03, 0.1, 0.3, 1};
  constexpr int kMaxRounds = 50;
  Stitches stitches;
  Borders borders(*soup);
  for (const double step : kSteps) {
    for (int round = 0; round < kMaxRounds; ++round) {
      const int before = stitches.merged_points + stitches.inserted_points;
      MergeBorderPoints(tolerance, soup->points, &borders, &stitches);
      InsertBorderPoints(step * tolerance, soup->points, &borders, &stitches);
      if (stitches.merged_points + stitches.inserted_points == before) break;
    }
  }
  soup->triangles = borders.ToTriangles();
  return stitches;
}

}  // namespace musclewarp
