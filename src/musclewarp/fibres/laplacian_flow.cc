// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/fibres/laplacian_flow.h"

#include <glog/logging.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace musclewarp {
namespace {

using Cell = VoxelGrid::Cell;

// Returns the voxel beyond face `side` (0: lower, 1: upper) along axis k, or -1
// if there is none.
int VoxelBeyond(const VoxelGrid& grid, int voxel, int k, int side) {
  Cell cell = grid.cells[voxel];
  cell[k] += side == 0 ? -1 : 1;
  return grid.At(cell);
}

// Returns the flow along axis k through the lower and the upper face of a
// voxel.
std::array<double, 2> FaceFlow(const LaplacianFlow& flow, int voxel, int k) {
  const int below = VoxelBeyond(*flow.grid, voxel, k, 0);
  const int above = VoxelBeyond(*flow.grid, voxel, k, 1);
  return {below < 0 ? -flow.outflow[voxel]
                    : flow.potential[voxel] - flow.potential[below],
          above < 0 ? flow.outflow[voxel]
                    : flow.potential[above] - flow.potential[voxel]};
}

// The time and side at which a point leaves a voxel along one axis. The time is
// infinite if the point does not leave.
struct Exit {
  double time = std::numeric_limits<double>::infinity();
  int side = 0;
};

// Returns the exit of a point at `at` (0 to 1) if the velocity is linear
// between the faces.
Exit ExitAlong(const std::array<double, 2>& face, double at) {
  const double slope = face[1] - face[0];
  const double velocity = face[0] + slope * at;
  Exit exit;
  if (velocity == 0) return exit;
  exit.side = velocity > 0 ? 1 : 0;
  // A face without flow in this direction is never reached.
  const double at_face = face[exit.side];
  if (at_face * velocity <= 0) return exit;
  const double way = (exit.side == 1 ? 1 : 0) - at;
  exit.time = std::abs(slope) < 1e-9 * std::abs(velocity)
                  ? way / velocity
                  : std::log(at_face / velocity) / slope;
  exit.time = std::max(0.0, exit.time);
  return exit;
}

double MovedAlong(const std::array<double, 2>& face, double at, double time) {
  const double slope = face[1] - face[0];
  const double velocity = face[0] + slope * at;
  const double moved = std::abs(slope * time) < 1e-9
                           ? velocity * time
                           : velocity / slope * std::expm1(slope * time);
  return std::clamp(at + moved, 0.0, 1.0);
}

// Follows the flow from a point, downstream (direction 1) or upstream (-1), to
// the surface of an end. The result does not contain the point itself.
std::vector<Eigen::RowVector3d> Trace(const LaplacianFlow& flow,
                                      const Eigen::RowVector3d& start,
                                      int direction) {
  const VoxelGrid& grid = *flow.grid;
  std::vector<Eigen::RowVector3d> points;
  const Cell first_cell = grid.CellOf(start);
  int voxel = grid.At(first_cell);
  CHECK_GE(voxel, 0);
  double at[3];
  for (int k = 0; k < 3; ++k) {
    at[k] = (start[k] - grid.origin[k]) / grid.size - first_cell[k];
  }
  // The potential changes monotonically, so that no voxel is passed twice.
  for (int steps = 0; steps < grid.num_voxels(); ++steps) {
    std::array<double, 2> faces[3];
    Exit first;
    int axis = -1;
    for (int k = 0; k < 3; ++k) {
      faces[k] = FaceFlow(flow, voxel, k);
      for (double& face : faces[k]) face *= direction;
      const Exit exit = ExitAlong(faces[k], at[k]);
      if (exit.time < first.time) {
        first = exit;
        axis = k;
      }
    }
    if (axis < 0) break;
    for (int k = 0; k < 3; ++k) {
      at[k] = MovedAlong(faces[k], at[k], first.time);
    }
    at[axis] = first.side;
    const Cell& cell = grid.cells[voxel];
    points.push_back(grid.origin +
                     grid.size * Eigen::RowVector3d(cell[0] + at[0],
                                                    cell[1] + at[1],
                                                    cell[2] + at[2]));
    voxel = VoxelBeyond(grid, voxel, axis, first.side);
    if (voxel < 0) break;  // through the surface
    at[axis] = 1 - first.side;
  }
  return points;
}

// Calls visit(voxel, neighbour, axis) for every two voxels with a common face.
// The voxel with the lower potential comes first.
template <typename Visit>
void ForEachFace(const LaplacianFlow& flow, const Visit& visit) {
  for (int v = 0; v < flow.grid->num_voxels(); ++v) {
    for (int k = 0; k < 3; ++k) {
      const int above = VoxelBeyond(*flow.grid, v, k, 1);
      if (above < 0) continue;
      const bool rises = flow.potential[v] <= flow.potential[above];
      visit(rises ? v : above, rises ? above : v, k);
    }
  }
}

// Returns the potential of the section on which seeds are spread: the section
// that crosses the most faces, among those through which nearly all of the flow
// passes. At ends that run along the muscle, a part of the flow has not yet
// entered or has already left.
double WidestLevel(const LaplacianFlow& flow) {
  constexpr int kLevels = 64;
  constexpr double kNearlyAll = 0.95;
  std::array<int, kLevels + 1> faces = {};
  std::array<double, kLevels + 1> flows = {};
  const auto level_above = [&](double potential) {
    return std::clamp(
        static_cast<int>(std::ceil(potential * kLevels - 0.5)), 0, kLevels);
  };
  // First the changes from level to level, then their cumulative sums.
  ForEachFace(flow, [&](int low, int high, int) {
    const int first = level_above(flow.potential[low]);
    const int last = level_above(flow.potential[high]);
    const double passing = flow.potential[high] - flow.potential[low];
    ++faces[first];
    --faces[last];
    flows[first] += passing;
    flows[last] -= passing;
  });
  std::partial_sum(faces.begin(), faces.end(), faces.begin());
  std::partial_sum(flows.begin(), flows.end(), flows.begin());
  const double most = *std::max_element(flows.begin(), flows.end() - 1);
  int widest = -1;
  for (int i = 0; i < kLevels; ++i) {
    if (flows[i] < kNearlyAll * most) continue;
    if (widest < 0 || faces[i] > faces[widest]) widest = i;
  }
  return (widest + 0.5) / kLevels;
}

// Returns points on the section with a given potential: four around each place
// where the potential has this value between the centres of two voxels.
Points SectionPoints(const LaplacianFlow& flow, double level) {
  constexpr double kAside = 0.25;  // of a voxel
  std::vector<Eigen::RowVector3d> points;
  ForEachFace(flow, [&](int low, int high, int axis) {
    const double u_0 = flow.potential[low];
    const double u_1 = flow.potential[high];
    if (u_0 > level || u_1 <= level) return;
    const Eigen::RowVector3d from = flow.grid->Center(low);
    const Eigen::RowVector3d to = flow.grid->Center(high);
    const Eigen::RowVector3d between =
        from + (level - u_0) / (u_1 - u_0) * (to - from);
    for (const int side_1 : {-1, 1}) {
      for (const int side_2 : {-1, 1}) {
        Eigen::RowVector3d point = between;
        point[(axis + 1) % 3] += side_1 * kAside * flow.grid->size;
        point[(axis + 2) % 3] += side_2 * kAside * flow.grid->size;
        points.push_back(point);
      }
    }
  });
  Points all(points.size(), 3);
  for (size_t i = 0; i < points.size(); ++i) all.row(i) = points[i];
  return all;
}

// Returns at most `most` of the points, at even intervals in their order.
Points Thinned(const Points& points, Eigen::Index most) {
  if (points.rows() <= most) return points;
  Points thinned(most, 3);
  for (Eigen::Index i = 0; i < most; ++i) {
    thinned.row(i) = points.row(i * points.rows() / most);
  }
  return thinned;
}

// Returns the number of faces of a voxel on the surface.
int NumOuterFaces(const VoxelGrid& grid, int voxel) {
  int faces = 0;
  for (int k = 0; k < 3; ++k) {
    for (const int side : {0, 1}) {
      faces += VoxelBeyond(grid, voxel, k, side) < 0;
    }
  }
  return faces;
}

int NumOuterFaces(const VoxelGrid& grid, const std::vector<int>& voxels) {
  int faces = 0;
  for (const int voxel : voxels) faces += NumOuterFaces(grid, voxel);
  return faces;
}

// Sets a uniform outflow, in sum `total`, through the surface of an end.
void SetOutflow(const VoxelGrid& grid,
                std::vector<int> end,
                double total,
                Eigen::VectorXd* outflow) {
  // This ends, since the voxels are connected and some are at the surface.
  for (int reach = 1; NumOuterFaces(grid, end) == 0; ++reach) {
    const std::vector<int> inside = end;
    for (const int voxel : inside) {
      for (const int near : grid.Around(voxel, reach)) end.push_back(near);
    }
    std::sort(end.begin(), end.end());
    end.erase(std::unique(end.begin(), end.end()), end.end());
  }
  const double each = total / NumOuterFaces(grid, end);
  for (const int voxel : end) (*outflow)[voxel] = each;
}

// Returns the matrix that maps a potential to the net flow into each voxel from
// its neighbours.
Eigen::SparseMatrix<double, Eigen::RowMajor> FlowMatrix(const VoxelGrid& grid) {
  const int count = grid.num_voxels();
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(count, count);
  matrix.reserve(Eigen::VectorXi::Constant(count, 7));
  for (int v = 0; v < count; ++v) {
    double diagonal = 0;
    for (int k = 0; k < 3; ++k) {
      for (const int side : {0, 1}) {
        const int neighbour = VoxelBeyond(grid, v, k, side);
        if (neighbour < 0) continue;
        ++diagonal;
        matrix.insert(v, neighbour) = -1;
      }
    }
    matrix.insert(v, v) = diagonal;
  }
  matrix.makeCompressed();
  return matrix;
}

// Returns an approximate potential for a unit flow between two sets, as in a
// muscle of constant cross section.
Eigen::VectorXd GuessPotential(const VoxelGrid& grid,
                               const std::vector<int>& origin,
                               const std::vector<int>& insertion) {
  const Eigen::ArrayXd from_origin = DistancesWithin(grid, origin);
  const Eigen::ArrayXd to_insertion = DistancesWithin(grid, insertion);
  const double length = from_origin.maxCoeff() / grid.size;
  return length * length / grid.num_voxels() * from_origin /
         (from_origin + to_insertion).max(grid.size);
}

}  // namespace

LaplacianFlow SolveFlow(const VoxelGrid& grid,
                        const std::vector<int>& origin,
                        const std::vector<int>& insertion) {
  CHECK(!origin.empty());
  CHECK(!insertion.empty());
  const int count = grid.num_voxels();
  LaplacianFlow flow;
  flow.grid = &grid;
  flow.outflow = Eigen::VectorXd::Zero(count);
  SetOutflow(grid, origin, -1, &flow.outflow);
  for (const int voxel : insertion) {
    CHECK(std::find(origin.begin(), origin.end(), voxel) == origin.end());
  }
  SetOutflow(grid, insertion, 1, &flow.outflow);
  Eigen::VectorXd source(count);
  for (int v = 0; v < count; ++v) {
    source[v] = NumOuterFaces(grid, v) * flow.outflow[v];
  }
  source.array() -= source.mean();  // rounding errors
  // The potential is defined up to a constant; conjugate gradients keep that of
  // the guess.
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double, Eigen::RowMajor>,
                           Eigen::Lower | Eigen::Upper>
      solver;
  // The flow is the difference between neighbours, about 1e-2 of the potential.
  solver.setTolerance(1e-6);
  const auto matrix = FlowMatrix(grid);
  solver.compute(matrix);
  flow.potential =
      solver.solveWithGuess(source, GuessPotential(grid, origin, insertion));
  const double lowest = flow.potential.minCoeff();
  const double range = flow.potential.maxCoeff() - lowest;
  flow.potential = (flow.potential.array() - lowest) / range;
  flow.outflow /= range;
  return flow;
}

Points StreamLine(const LaplacianFlow& flow, const Eigen::RowVector3d& point) {
  auto points = Trace(flow, point, -1);
  std::reverse(points.begin(), points.end());
  points.push_back(point);
  for (const auto& later : Trace(flow, point, 1)) points.push_back(later);
  Points line(points.size(), 3);
  for (size_t i = 0; i < points.size(); ++i) line.row(i) = points[i];
  return line;
}

Points SpreadOverSection(const LaplacianFlow& flow, int count) {
  constexpr int kRounds = 8;
  constexpr int kCandidates = 400;  // at most, or kShare for each point
  constexpr int kShare = 8;
  const Points candidates = Thinned(SectionPoints(flow, WidestLevel(flow)),
                                    std::max(kCandidates, kShare * count));
  const Eigen::Index size = candidates.rows();
  const Eigen::Index chosen = std::min<Eigen::Index>(count, size);
  if (chosen <= 0) return Points(0, 3);
  // Start with points that are far from each other, then move each to the
  // centre of its share.
  Points centers(chosen, 3);
  Eigen::VectorXd nearest = (candidates.rowwise() - candidates.colwise().mean())
                                .rowwise()
                                .squaredNorm();
  for (Eigen::Index c = 0; c < chosen; ++c) {
    Eigen::Index farthest;
    nearest.maxCoeff(&farthest);
    centers.row(c) = candidates.row(farthest);
    const Eigen::VectorXd squared =
        (candidates.rowwise() - centers.row(c)).rowwise().squaredNorm();
    nearest = c == 0 ? squared : Eigen::VectorXd(nearest.cwiseMin(squared));
  }
  for (int round = 0; round < kRounds; ++round) {
    Points sums = Points::Zero(chosen, 3);
    Eigen::VectorXi shares = Eigen::VectorXi::Zero(chosen);
    for (Eigen::Index i = 0; i < size; ++i) {
      Eigen::Index c;
      (centers.rowwise() - candidates.row(i))
          .rowwise()
          .squaredNorm()
          .minCoeff(&c);
      sums.row(c) += candidates.row(i);
      ++shares[c];
    }
    for (Eigen::Index c = 0; c < chosen; ++c) {
      if (shares[c] > 0) centers.row(c) = sums.row(c) / shares[c];
    }
  }
  // The centre of a curved share may be outside the muscle; the nearest
  // candidate is not.
  std::vector<char> is_taken(size, 0);
  for (Eigen::Index c = 0; c < chosen; ++c) {
    Eigen::Index best = -1;
    double best_squared = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < size; ++i) {
      const double squared = (candidates.row(i) - centers.row(c)).squaredNorm();
      if (is_taken[i] || squared >= best_squared) continue;
      best_squared = squared;
      best = i;
    }
    is_taken[best] = 1;
    centers.row(c) = candidates.row(best);
  }
  return centers;
}

}  // namespace musclewarp
