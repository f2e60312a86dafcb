// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/polygonize.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace musclewarp::phantom {
namespace {

using Quad = std::array<int, 4>;

// Field values at the corners of a regular grid.
class Grid {
 public:
  Grid(const Field& field, const Eigen::AlignedBox3d& box, double cell)
      : origin_(box.min()), cell_(cell) {
    for (int axis = 0; axis < 3; ++axis) {
      size_[axis] = std::ceil(box.sizes()[axis] / cell) + 1;
    }
    values_.resize(static_cast<size_t>(size_[0]) * size_[1] * size_[2]);
    for (int k = 0; k < size_[2]; k += kBlock) {
      for (int j = 0; j < size_[1]; j += kBlock) {
        for (int i = 0; i < size_[0]; i += kBlock) FillBlock(field, {i, j, k});
      }
    }
  }

  const Eigen::Array3i& size() const { return size_; }

  size_t Index(const Eigen::Array3i& at) const {
    return at[0] + static_cast<size_t>(size_[0]) *
                       (at[1] + static_cast<size_t>(size_[1]) * at[2]);
  }

  double Value(const Eigen::Array3i& at) const { return values_[Index(at)]; }

  void SetValue(const Eigen::Array3i& at, double value) {
    values_[Index(at)] = value;
  }

  Eigen::Vector3d Position(const Eigen::Array3i& at) const {
    return origin_ + cell_ * at.matrix().cast<double>();
  }

 private:
  static constexpr int kBlock = 4;

  // Blocks that the surface cannot reach get the value of their centre: only
  // its sign is used.
  void FillBlock(const Field& field, const Eigen::Array3i& first) {
    const Eigen::Array3i last = (first + kBlock).min(size_);
    const double half = 0.5 * (kBlock - 1) * cell_;
    const double at_centre =
        field(Position(first) + Eigen::Vector3d::Constant(half));
    const bool is_far = std::abs(at_centre) > 2 * std::sqrt(3.0) * half;
    for (int k = first[2]; k < last[2]; ++k) {
      for (int j = first[1]; j < last[1]; ++j) {
        for (int i = first[0]; i < last[0]; ++i) {
          values_[Index({i, j, k})] =
              is_far ? at_centre : field(Position({i, j, k}));
        }
      }
    }
  }

  Eigen::Vector3d origin_;
  double cell_;
  Eigen::Array3i size_;
  std::vector<double> values_;
};

Eigen::Array3i Corner(int corner) {
  return {corner & 1, (corner >> 1) & 1, (corner >> 2) & 1};
}

// Where two diagonally opposite corners of a cell (or of one of its faces) are
// inside and the others are not, or the other way round, the net would touch
// itself. Filling an outside corner of each such place, again and again until
// there is none, makes it a manifold ("well-composed" grids: Latecki 1997).
bool FillAmbiguousCell(const Eigen::Array3i& cell, Grid* grid) {
  const auto is_inside = [&](int corner) {
    return grid->Value(cell + Corner(corner)) < 0;
  };
  const auto fill = [&](int corner) {
    grid->SetValue(cell + Corner(corner), -1e-3);
    return true;
  };
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << (axis + 1) % 3;
    const int v = 1 << (axis + 2) % 3;
    for (const int base : {0, 1 << axis}) {
      const bool a = is_inside(base);
      const bool b = is_inside(base | u);
      if (a == b || is_inside(base | v) != b || is_inside(base | u | v) != a) {
        continue;
      }
      return fill(a ? base | u : base);
    }
  }
  int inside_count = 0;
  for (int corner = 0; corner < 8; ++corner) inside_count += is_inside(corner);
  for (int corner = 0; corner < 4; ++corner) {
    const bool a = is_inside(corner);
    if (a != is_inside(7 - corner)) continue;
    if (a && inside_count == 2) return fill(corner ^ 1);
    if (!a && inside_count == 6) return fill(corner);
  }
  return false;
}

void FillAmbiguousCells(Grid* grid) {
  bool is_changed = true;
  while (is_changed) {
    is_changed = false;
    const Eigen::Array3i size = grid->size();
    for (int k = 0; k + 1 < size[2]; ++k) {
      for (int j = 0; j + 1 < size[1]; ++j) {
        for (int i = 0; i + 1 < size[0]; ++i) {
          is_changed |= FillAmbiguousCell({i, j, k}, grid);
        }
      }
    }
  }
}

// Finds the mean of the points in which the surface crosses the edges of a
// cell. Returns false if it crosses none.
bool CellPoint(const Grid& grid,
               const Eigen::Array3i& cell,
               Eigen::Vector3d* point) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (int corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      if ((corner >> axis) & 1) continue;
      const Eigen::Array3i a = cell + Corner(corner);
      const Eigen::Array3i b = cell + Corner(corner | 1 << axis);
      const double value_a = grid.Value(a);
      const double value_b = grid.Value(b);
      if ((value_a < 0) == (value_b < 0)) continue;
      const double t = value_a / (value_a - value_b);
      sum += (1 - t) * grid.Position(a) + t * grid.Position(b);
      ++count;
    }
  }
  if (count > 0) *point = sum / count;
  return count > 0;
}

struct QuadMesh {
  std::vector<Eigen::Vector3d> points;
  std::vector<Quad> quads;
};

// Makes an outward oriented quad around every grid edge on which the sign
// changes.
void AppendQuads(const Grid& grid,
                 const std::vector<int>& point_of_cell,
                 const Eigen::Array3i& at,
                 std::vector<Quad>* quads) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    Eigen::Array3i next = at;
    ++next[axis];
    if (next[axis] >= grid.size()[axis]) continue;
    const bool is_inside = grid.Value(at) < 0;
    if (is_inside == (grid.Value(next) < 0)) continue;
    CHECK(at[u] > 0 && at[v] > 0) << "the solid reaches the border of its box";
    Quad quad;
    constexpr int kAround[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    for (int i = 0; i < 4; ++i) {
      Eigen::Array3i cell = at;
      cell[u] -= kAround[i][0];
      cell[v] -= kAround[i][1];
      quad[i] = point_of_cell[grid.Index(cell)];
    }
    // The cells go round counterclockwise seen from the axis' positive end.
    if (!is_inside) std::swap(quad[1], quad[3]);
    quads->push_back(quad);
  }
}

QuadMesh SurfaceNet(const Grid& grid) {
  QuadMesh mesh;
  const Eigen::Array3i size = grid.size();
  std::vector<int> point_of_cell(grid.Index(size - 1) + 1, -1);
  for (int k = 0; k + 1 < size[2]; ++k) {
    for (int j = 0; j + 1 < size[1]; ++j) {
      for (int i = 0; i + 1 < size[0]; ++i) {
        Eigen::Vector3d point;
        if (!CellPoint(grid, {i, j, k}, &point)) continue;
        point_of_cell[grid.Index({i, j, k})] = mesh.points.size();
        mesh.points.push_back(point);
      }
    }
  }
  for (int k = 0; k < size[2]; ++k) {
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) {
        AppendQuads(grid, point_of_cell, {i, j, k}, &mesh.quads);
      }
    }
  }
  return mesh;
}

// The first-order step onto the surface, at most a millimetre, and the unit
// normal.
struct Pull {
  Eigen::Vector3d normal;
  Eigen::Vector3d step;
};

Pull PullToward(const Field& field, const Eigen::Vector3d& p) {
  constexpr double kStep = 0.01;  // mm
  const double value = field(p);
  Eigen::Vector3d gradient;
  for (int axis = 0; axis < 3; ++axis) {
    gradient[axis] =
        (field(p + kStep * Eigen::Vector3d::Unit(axis)) - value) / kStep;
  }
  const double norm = std::max(gradient.norm(), 1e-3);
  Pull pull;
  pull.normal = gradient / norm;
  pull.step = std::clamp(-value / norm, -1.0, 1.0) * pull.normal;
  return pull;
}

// Moves every point toward the mean of its neighbours within the tangent plane
// and back onto the surface.
void Smooth(const Field& field, int steps, QuadMesh* mesh) {
  std::vector<Eigen::Vector3d>& points = mesh->points;
  std::vector<Eigen::Vector3d> sums(points.size());
  std::vector<int> counts(points.size());
  for (int step = 0; step < steps; ++step) {
    std::fill(sums.begin(), sums.end(), Eigen::Vector3d::Zero());
    std::fill(counts.begin(), counts.end(), 0);
    for (const Quad& quad : mesh->quads) {
      for (int i = 0; i < 4; ++i) {
        sums[quad[i]] += points[quad[(i + 1) % 4]] + points[quad[(i + 3) % 4]];
        counts[quad[i]] += 2;
      }
    }
    // Points do not depend on each other here.
#pragma omp parallel for
    for (size_t i = 0; i < points.size(); ++i) {
      const Pull pull = PullToward(field, points[i]);
      const Eigen::Vector3d shift = 0.5 * (sums[i] / counts[i] - points[i]);
      points[i] += shift - pull.normal.dot(shift) * pull.normal + pull.step;
    }
  }
  for (Eigen::Vector3d& p : points) {
    for (int i = 0; i < 2; ++i) p += PullToward(field, p).step;
  }
}

// Splits each quad along its shorter diagonal.
TriangleSoup Triangulate(const QuadMesh& mesh) {
  TriangleSoup soup;
  soup.points.resize(mesh.points.size(), 3);
  for (size_t i = 0; i < mesh.points.size(); ++i) {
    soup.points.row(i) = mesh.points[i].transpose();
  }
  soup.triangles.resize(2 * mesh.quads.size(), 3);
  for (size_t i = 0; i < mesh.quads.size(); ++i) {
    const Quad& q = mesh.quads[i];
    const double diagonal_02 =
        (soup.points.row(q[0]) - soup.points.row(q[2])).squaredNorm();
    const double diagonal_13 =
        (soup.points.row(q[1]) - soup.points.row(q[3])).squaredNorm();
    const int first = diagonal_02 <= diagonal_13 ? 0 : 1;
    const auto corner = [&](int k) { return q[(first + k) % 4]; };
    soup.triangles.row(2 * i) << corner(0), corner(1), corner(2);
    soup.triangles.row(2 * i + 1) << corner(0), corner(2), corner(3);
  }
  return soup;
}

}  // namespace

TriangleSoup PolygonizeField(const Field& field,
                             const Eigen::AlignedBox3d& box,
                             const PolygonizeOptions& options) {
  Grid grid(field, box, options.cell);
  FillAmbiguousCells(&grid);
  QuadMesh mesh = SurfaceNet(grid);
  Smooth(field, options.smoothing_steps, &mesh);
  for (Eigen::Vector3d& p : mesh.points) p = RoundedPoint(p);
  return Triangulate(mesh);
}

Eigen::Vector3d RoundedPoint(const Eigen::Vector3d& p) {
  constexpr double kPerMillimetre = 1024;
  return (p * kPerMillimetre).array().round() / kPerMillimetre;
}

}  // namespace musclewarp::phantom
