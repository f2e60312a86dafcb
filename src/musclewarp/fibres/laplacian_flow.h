// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A flow through a muscle from its origin to its insertion, whose stream lines
// are the paths of the muscle's fibres. It is the gradient of a harmonic
// potential, with uniform inflow through the surface of the origin, uniform
// outflow through the surface of the insertion, and no flow through the rest of
// the surface (Choi and Blemker, "Skeletal Muscle Fascicle Arrangements Can Be
// Reconstructed Using a Laplacian Vector Field Simulation", PLoS ONE 8, 2013),
// so that fibres are spread over both areas. It is discretised by finite
// volumes on the voxels of a grid.
//
//   const LaplacianFlow flow = SolveFlow(grid, origin, insertion);
//   const Points seeds = SpreadOverSection(flow, 100);
//   const Points course = StreamLine(flow, seeds.row(0));
struct LaplacianFlow {
  // The grid must outlive the flow.
  const VoxelGrid* grid = nullptr;

  // The potential of every voxel, from 0 to 1.
  Eigen::VectorXd potential;

  // The flow out of every voxel through each of its faces on the surface of the
  // muscle: negative at the origin, positive at the insertion, 0 elsewhere. The
  // flow between two voxels is the difference of their potentials.
  Eigen::VectorXd outflow;
};

// Computes the flow between two sets of voxels. A set in the interior of the
// muscle is extended until it reaches the surface. The result keeps a pointer
// to the grid. Preconditions (CHECKed): neither set is empty, and no voxel is
// in both.
LaplacianFlow SolveFlow(const VoxelGrid& grid,
                        const std::vector<int>& origin,
                        const std::vector<int>& insertion);

// Returns the stream line through a point, from the surface of the origin to
// that of the insertion: its crossings of voxel faces and the point itself, #P
// x 3, mm. Stream lines are exact for velocities that are linear in each voxel
// (Pollock, "Semianalytical Computation of Path Lines for Finite-Difference
// Models", Ground Water 26, 1988), so that none leaves the voxels or ends
// before it reaches the origin or the insertion. Precondition (CHECKed): the
// point is in a voxel.
Points StreamLine(const LaplacianFlow& flow, const Eigen::RowVector3d& point);

// Returns at most `count` points (#P x 3, mm), spread evenly over a section of
// constant potential: the widest of those through which nearly all of the flow
// passes. Each point is near the centre of an equal share of the section
// (Lloyd's algorithm), so that the stream lines through them fill the muscle
// evenly.
Points SpreadOverSection(const LaplacianFlow& flow, int count);

}  // namespace musclewarp
