// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/initial_separation/solid_distance.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct MedialCellOptions {
  // Kept between two cells, and from bones, half of it by each side, mm. Twice
  // StepOptions::gap, so that the steps that follow find room.
  double margin = 0.2;

  // The size of the voxels that tell which parts of a cell are connected, mm.
  // With larger voxels a scene is prepared faster, but muscles are moved
  // farther.
  double voxel_size = 1.5;

  // Surfaces farther away than this do not bound the cell, mm.
  double range = 3;

  // A straight path between two voxels is tested down to pieces of this length,
  // mm: plates thinner than that may be passed through. A plate of 0.25 mm is
  // found (tests/certified_contact/medial_cell_test.cc).
  double thinnest_wall = 0.2;

  bool IsValid(std::string* error) const;
};

// The part of space that belongs to a muscle where meshes overlap as they are
// delivered: everything that is outside all bones and deeper in this muscle
// than in any other. Between two muscles that overlap, their cells meet at the
// common medial surface, so that both can come to lie on it without pushing
// each other to and fro. What a thin bone cuts off from the largest connected
// part does not belong to the cell: the muscle stays on the side of its bulk.
//
//   const MedialCell cell(options, psoas, {&iliacus}, {&femur, &pelvis});
//   const Points apart = cell.Project(psoas.mesh().points());
class MedialCell {
 public:
  // Keeps references to all of them. Precondition (CHECKed): the options are
  // valid.
  MedialCell(const MedialCellOptions& options,
             const SolidDistance& muscle,
             std::vector<const SolidDistance*> other_muscles,
             std::vector<const SolidDistance*> bones);

  // Returns the signed distance of a point to the cell, mm: above zero, how far
  // it is beyond the surface of a bone or a medial surface; below zero, how far
  // it is from them, at most the range. The muscle's own surface does not bound
  // the cell. It changes by no more than the way between two points.
  double SignedDistance(const Eigen::RowVector3d& p) const;

  // The same, with the muscle's own surface as a bound of the cell too: the
  // region that the muscle may fill. The functions of two muscles add up to
  // half the margin or more at every place.
  double RegionDistance(const Eigen::RowVector3d& p) const;

  // The same with a distance to the muscle's surface, `own`, that is given and
  // may be less than it is: the region then reaches farther within the cell.
  double RegionDistance(const Eigen::RowVector3d& p, double own) const;

  // Returns the direction in which the signed distance falls, of unit length;
  // zero where no surface is near.
  Eigen::RowVector3d Inward(const Eigen::RowVector3d& p) const;

  // Returns the vertices of the muscle (#V x 3, mm, in the places of its mesh),
  // of which those outside the cell, or in a part that is cut off, are moved to
  // its border near them.
  Points Project(const Points& points) const;

  // The same for several muscles. It takes less time than one after the other,
  // as work that cannot be divided is done for several of them at once.
  // Precondition (CHECKed): there are points for every cell.
  static std::vector<Points> Project(
      const std::vector<const MedialCell*>& cells,
      const std::vector<const Points*>& points);

 private:
  struct VoxelGrid;

  // Returns the signed distance, or -depth where it is below that, which takes
  // less time the less depth is asked for.
  double DistanceDownTo(double depth, const Eigen::RowVector3d& p) const;

  // Returns voxels over the muscle with their signed distances to the cell, as
  // far as they say whether the paths between neighbours are free.
  VoxelGrid SampledVoxels() const;

  // Finds for the voxel of each point the nearest one in the largest connected
  // part.
  void FindMainPart(const Points& points, VoxelGrid* grid) const;

  Points Project(const Points& points, const VoxelGrid& grid) const;

  // True if the straight path between two points in the cell stays in it; the
  // signed distances are those of the points.
  bool IsPathFree(const Eigen::RowVector3d& a,
                  double distance_a,
                  const Eigen::RowVector3d& b,
                  double distance_b) const;

  // Returns the point where the path from `q`, in the cell, towards `p` meets
  // its border.
  Eigen::RowVector3d Border(const Eigen::RowVector3d& q,
                            double distance_q,
                            const Eigen::RowVector3d& p) const;

  MedialCellOptions options_;
  const SolidDistance& muscle_;
  std::vector<const SolidDistance*> other_muscles_;
  std::vector<const SolidDistance*> bones_;
};

}  // namespace musclewarp
