// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// The flow through a muscle from its origin to its insertion that follows the
// gradient of a harmonic potential with no flow through the walls: the course
// of its fibres (Choi and Blemker, Skeletal Muscle Fascicle Arrangements Can Be
// Reconstructed Using a Laplacian Vector Field Simulation, PLoS ONE 8, 2013).
// On voxels, finite volumes; stream lines are exact for velocities linear in
// each voxel (Pollock, Semianalytical Computation of Path Lines for
// Finite-Difference Models, Ground Water 26, 1988), so that none leaves the
// voxels or ends but at the origin or the insertion.
struct LaplacianFlow {
  const VoxelGrid* grid = nullptr;
  Eigen::VectorXd potential;  // by voxel: 0 at the origin, 1 at the insertion
};

// `origin` and `insertion`: voxels. Keeps a pointer to the grid. Preconditions
// (CHECKed): neither is empty, no voxel is in both.
LaplacianFlow SolveFlow(const VoxelGrid& grid,
                        const std::vector<int>& origin,
                        const std::vector<int>& insertion);

// The stream line through a point inside a voxel, from the origin to the
// insertion, #P x 3, mm: where it passes from voxel to voxel. Precondition
// (CHECKed): the point is in a voxel.
Points StreamLine(const LaplacianFlow& flow, const Eigen::RowVector3d& point);

// At most `count` points (#P x 3) spread evenly over the widest section of the
// muscle along which the potential is constant: each is near the middle of an
// equal share of it (Lloyd's algorithm).
Points SpreadOverSection(const LaplacianFlow& flow, int count);

}  // namespace musclewarp
