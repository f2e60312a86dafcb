// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/fibres/voxel_grid.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A flow through a muscle from its origin to its insertion, whose stream lines
// are the courses of the muscle's fibres. It follows the gradient of a harmonic
// potential. It comes in evenly through the surface of the origin, goes out
// evenly through that of the insertion, and no other wall lets it pass (Choi
// and Blemker, "Skeletal Muscle Fascicle Arrangements Can Be Reconstructed
// Using a Laplacian Vector Field Simulation", PLoS ONE 8, 2013), so that fibres
// are spread over both areas. It is discretised by finite volumes on the voxels
// of a grid.
//
//   const LaplacianFlow flow = SolveFlow(grid, origin, insertion);
//   const Points seeds = SpreadOverSection(flow, 100);
//   const Points course = StreamLine(flow, seeds.row(0));
struct LaplacianFlow {
  // The grid must outlive the flow.
  const VoxelGrid* grid = nullptr;

  // The potential in every voxel, from 0 to 1.
  Eigen::VectorXd potential;

  // The flow out of every voxel through each of its faces on the surface of the
  // muscle: negative at the origin, positive at the insertion, else 0. Between
  // two voxels the flow is the difference of their potentials.
  Eigen::VectorXd outflow;
};

// Computes the flow between two sets of voxels. Of an end inside of the muscle
// what is around it counts, as far as the surface. The result keeps a pointer
// to the grid. Preconditions (CHECKed): neither set is empty, and no voxel is
// in both.
LaplacianFlow SolveFlow(const VoxelGrid& grid,
                        const std::vector<int>& origin,
                        const std::vector<int>& insertion);

// Returns the stream line through a point, from the surface of the origin to
// that of the insertion: the places where it passes from voxel to voxel, #P x
// 3, mm. Stream lines are exact for velocities that are linear in each voxel
// (Pollock, "Semianalytical Computation of Path Lines for Finite-Difference
// Models", Ground Water 26, 1988). So no stream line leaves the voxels, and
// none ends before it reaches the origin or the insertion. Precondition
// (CHECKed): the point is in a voxel.
Points StreamLine(const LaplacianFlow& flow, const Eigen::RowVector3d& point);

// Returns at most `count` points (#P x 3, mm), spread evenly over the widest
// section of the muscle on which the potential is constant and which nearly all
// of the flow passes. Each is near the
// centre of an equal share of the section (Lloyd's algorithm), so that the
// stream lines through them fill the muscle evenly.
Points SpreadOverSection(const LaplacianFlow& flow, int count);

}  // namespace musclewarp
