// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/voxel_grid.h"

#include <glog/logging.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "musclewarp/fibres/surface_cells.h"
#include "musclewarp/mesh/measures.h"

namespace musclewarp {
namespace {

// Returns twice the signed area of the triangle p, a, b, projected along z.
double Side(const Eigen::RowVector3d& a,
            const Eigen::RowVector3d& b,
            double x,
            double y) {
  return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

// Returns the heights at which the vertical line through the centres of each
// column of cells crosses the mesh.
std::vector<std::vector<double>> Crossings(const TriangleSoup& mesh,
                                           const VoxelGrid& grid) {
  std::vector<std::vector<double>> crossings(grid.counts[0] * grid.counts[1]);
  for (Eigen::Index f = 0; f < mesh.triangles.rows(); ++f) {
    Eigen::RowVector3d p[3];
    for (int c = 0; c < 3; ++c) {
      p[c] = mesh.points.row(mesh.triangles(f, c));
    }
    const double area = Side(p[0], p[1], p[2][0], p[2][1]);
    if (area == 0) continue;
    int lower[2], upper[2];
    for (int k = 0; k < 2; ++k) {
      const auto [low, high] = std::minmax({p[0][k], p[1][k], p[2][k]});
      lower[k] =
          static_cast<int>(std::ceil((low - grid.origin[k]) / grid.size - 0.5));
      upper[k] = static_cast<int>(
          std::floor((high - grid.origin[k]) / grid.size - 0.5));
    }
    for (int j = lower[1]; j <= upper[1]; ++j) {
      for (int i = lower[0]; i <= upper[0]; ++i) {
        const double x = grid.origin[0] + (i + 0.5) * grid.size;
        const double y = grid.origin[1] + (j + 0.5) * grid.size;
        const double w0 = Side(p[1], p[2], x, y) / area;
        const double w1 = Side(p[2], p[0], x, y) / area;
        const double w2 = Side(p[0], p[1], x, y) / area;
        if (w0 < 0 || w1 < 0 || w2 < 0) continue;
        crossings[j * grid.counts[0] + i].push_back(
            w0 * p[0][2] + w1 * p[1][2] + w2 * p[2][2]);
      }
    }
  }
  return crossings;
}

// Finds the cells whose centres are inside, by parity along the columns. A
// column whose line meets an edge, which may be counted twice or not at all, is
// left out if its number of crossings is odd.
std::vector<char> InsideCells(const TriangleSoup& mesh, const VoxelGrid& grid) {
  std::vector<char> inside(grid.index_of.size(), 0);
  auto crossings = Crossings(mesh, grid);
  for (size_t column = 0; column < crossings.size(); ++column) {
    std::vector<double>& heights = crossings[column];
    if (heights.size() % 2 != 0) continue;
    std::sort(heights.begin(), heights.end());
    for (size_t i = 0; i < heights.size(); i += 2) {
      const int first = static_cast<int>(
          std::ceil((heights[i] - grid.origin[2]) / grid.size - 0.5));
      const int last = static_cast<int>(
          std::floor((heights[i + 1] - grid.origin[2]) / grid.size - 0.5));
      for (int k = std::max(0, first); k <= std::min(last, grid.counts[2] - 1);
           ++k) {
        inside[k * crossings.size() + column] = 1;
      }
    }
  }
  return inside;
}

// Returns the numbers of the six neighbours of a cell. All exist for a cell
// that is not empty, since the outermost layer of cells is empty.
std::array<int, 6> NeighboursOf(const VoxelGrid& grid, int cell) {
  const int row = grid.counts[0];
  const int layer = grid.counts[0] * grid.counts[1];
  return {
      cell - 1, cell + 1, cell - row, cell + row, cell - layer, cell + layer};
}

// Cells in the order in which a flood reaches them from the first ones, and for
// each the index of its predecessor in this order; -1 for the first ones.
struct Reached {
  std::vector<int> cells;
  std::vector<int> before;
};

// Floods the open cells from `first` over faces, and marks those that are
// reached.
Reached Flood(const VoxelGrid& grid,
              std::vector<int> first,
              const std::vector<char>& is_open,
              std::vector<char>* is_reached) {
  Reached reached;
  reached.cells = std::move(first);
  reached.before.assign(reached.cells.size(), -1);
  for (const int cell : reached.cells) (*is_reached)[cell] = 1;
  for (size_t i = 0; i < reached.cells.size(); ++i) {
    for (const int neighbour : NeighboursOf(grid, reached.cells[i])) {
      if (!is_open[neighbour] || (*is_reached)[neighbour]) continue;
      (*is_reached)[neighbour] = 1;
      reached.cells.push_back(neighbour);
      reached.before.push_back(static_cast<int>(i));
    }
  }
  return reached;
}

// Returns the largest set of inside cells that is connected over faces.
std::vector<int> LargestPiece(const VoxelGrid& grid,
                              const std::vector<char>& inside) {
  std::vector<char> is_reached(inside.size(), 0);
  std::vector<int> largest;
  for (size_t start = 0; start < inside.size(); ++start) {
    if (!inside[start] || is_reached[start]) continue;
    std::vector<int> piece =
        Flood(grid, {static_cast<int>(start)}, inside, &is_reached).cells;
    if (piece.size() > largest.size()) largest = std::move(piece);
  }
  return largest;
}

// Adds the parts of the mesh that are thinner than a voxel: the cells inside or
// on the surface that are more than kThick cells away from the piece, and the
// shortest paths to them. Nearer cells are the rim of the piece.
std::vector<int> WithThinParts(const VoxelGrid& grid,
                               std::vector<int> piece,
                               const std::vector<char>& inside,
                               const std::vector<char>& surface) {
  constexpr int kThick = 3;
  std::vector<char> is_open = surface;
  for (size_t i = 0; i < inside.size(); ++i) is_open[i] |= inside[i];
  std::vector<char> is_reached(inside.size(), 0);
  const Reached reached = Flood(grid, piece, is_open, &is_reached);
  std::vector<int> depth(reached.cells.size(), 0);
  std::vector<char> is_kept(reached.cells.size(), 0);
  for (size_t i = piece.size(); i < reached.cells.size(); ++i) {
    depth[i] = depth[reached.before[i]] + 1;
    if (depth[i] <= kThick) continue;
    for (int k = static_cast<int>(i); depth[k] > 0 && !is_kept[k];
         k = reached.before[k]) {
      is_kept[k] = 1;
      piece.push_back(reached.cells[k]);
    }
  }
  return piece;
}

void NumberCells(std::vector<int> cells, VoxelGrid* grid) {
  std::sort(cells.begin(), cells.end());
  const int layer = grid->counts[0] * grid->counts[1];
  for (const int cell : cells) {
    grid->index_of[cell] = grid->num_voxels();
    grid->cells.push_back({cell % grid->counts[0],
                           cell / grid->counts[0] % grid->counts[1],
                           cell / layer});
  }
}

}  // namespace

Eigen::RowVector3d VoxelGrid::Center(int voxel) const {
  const Cell& cell = cells[voxel];
  return origin +
         size * Eigen::RowVector3d(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5);
}

int VoxelGrid::At(const Cell& cell) const {
  for (int k = 0; k < 3; ++k) {
    if (cell[k] < 0 || cell[k] >= counts[k]) return -1;
  }
  return index_of[NumberOf(cell)];
}

VoxelGrid::Cell VoxelGrid::CellOf(const Eigen::RowVector3d& point) const {
  Cell cell;
  for (int k = 0; k < 3; ++k) {
    cell[k] = static_cast<int>(std::floor((point[k] - origin[k]) / size));
  }
  return cell;
}

std::vector<int> VoxelGrid::Around(int voxel, int reach) const {
  const Cell& center = cells[voxel];
  std::vector<int> around;
  for (int dz = -reach; dz <= reach; ++dz) {
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        const int other = At({center[0] + dx, center[1] + dy, center[2] + dz});
        if (other >= 0 && other != voxel) around.push_back(other);
      }
    }
  }
  return around;
}

int VoxelGrid::Nearest(const Eigen::RowVector3d& point) const {
  constexpr int kReach = 2;
  const Cell center = CellOf(point);
  int nearest = -1;
  double nearest_squared = std::numeric_limits<double>::infinity();
  for (int dz = -kReach; dz <= kReach; ++dz) {
    for (int dy = -kReach; dy <= kReach; ++dy) {
      for (int dx = -kReach; dx <= kReach; ++dx) {
        const int voxel = At({center[0] + dx, center[1] + dy, center[2] + dz});
        if (voxel < 0) continue;
        const double squared = (Center(voxel) - point).squaredNorm();
        if (squared < nearest_squared) {
          nearest_squared = squared;
          nearest = voxel;
        }
      }
    }
  }
  return nearest;
}

VoxelGrid Voxelize(const TriangleSoup& mesh, int wanted) {
  // The number of voxels across the mean thickness of a sheet, and the largest
  // factor by which this may increase the number of voxels.
  constexpr double kAcross = 3;
  constexpr double kMaxIncrease = 8;
  const double volume = SignedVolume(mesh.points, mesh.triangles);
  CHECK_GT(volume, 0);
  const double thickness =
      2 * volume / SurfaceArea(mesh.points, mesh.triangles);
  VoxelGrid grid;
  grid.size =
      std::max(std::min(std::cbrt(volume / wanted), thickness / kAcross),
               std::cbrt(volume / (kMaxIncrease * wanted)));
  const Eigen::RowVector3d lower = mesh.points.colwise().minCoeff();
  const Eigen::RowVector3d upper = mesh.points.colwise().maxCoeff();
  // These shares are not round numbers, so that columns do not meet edges of
  // regular meshes.
  const Eigen::RowVector3d shift(0.9271, 0.8817, 0.9043);
  grid.origin = lower - grid.size * (shift + Eigen::RowVector3d::Ones());
  for (int k = 0; k < 3; ++k) {
    grid.counts[k] =
        2 +
        static_cast<int>(std::ceil((upper[k] - grid.origin[k]) / grid.size));
  }
  grid.index_of.assign(grid.counts[0] * grid.counts[1] * grid.counts[2], -1);
  const std::vector<char> inside = InsideCells(mesh, grid);
  std::vector<int> piece = LargestPiece(grid, inside);
  if (!piece.empty()) {
    piece =
        WithThinParts(grid, std::move(piece), inside, SurfaceCells(mesh, grid));
  }
  NumberCells(std::move(piece), &grid);
  return grid;
}

Points Centers(const VoxelGrid& grid) {
  Points centers(grid.num_voxels(), 3);
  for (int v = 0; v < grid.num_voxels(); ++v) centers.row(v) = grid.Center(v);
  return centers;
}

Eigen::VectorXd DistancesWithin(const VoxelGrid& grid,
                                const std::vector<int>& sources) {
  // Steps to the 26 neighbours have lengths of 3, 4 or 5 thirds of an edge
  // (Borgefors, "Distance Transformations in Digital Images", 1986). Since
  // distances are integers, the queue is a ring of lists, one for each distance
  // that occurs.
  constexpr int kUnit = 3;
  constexpr int kLongest = 5;
  constexpr int kUnknown = std::numeric_limits<int>::max();
  std::vector<int> distances(grid.num_voxels(), kUnknown);
  std::array<std::vector<int>, kLongest + 1> ring;
  for (const int source : sources) {
    distances[source] = 0;
    ring[0].push_back(source);
  }
  size_t waiting = sources.size();
  for (int distance = 0; waiting > 0; ++distance) {
    std::vector<int>& here = ring[distance % ring.size()];
    for (size_t i = 0; i < here.size(); ++i) {
      if (distances[here[i]] != distance) continue;
      const VoxelGrid::Cell cell = grid.cells[here[i]];
      for (int dz = -1; dz <= 1; ++dz) {
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            const int axes = (dx != 0) + (dy != 0) + (dz != 0);
            const int next =
                grid.At({cell[0] + dx, cell[1] + dy, cell[2] + dz});
            const int farther = distance + kUnit - 1 + axes;
            if (axes == 0 || next < 0 || distances[next] <= farther) continue;
            distances[next] = farther;
            ring[farther % ring.size()].push_back(next);
            ++waiting;
          }
        }
      }
    }
    waiting -= here.size();
    here.clear();
  }
  Eigen::VectorXd result(grid.num_voxels());
  for (int v = 0; v < grid.num_voxels(); ++v) {
    result[v] = distances[v] == kUnknown
                    ? std::numeric_limits<double>::infinity()
                    : grid.size * distances[v] / kUnit;
  }
  return result;
}

}  // namespace musclewarp
