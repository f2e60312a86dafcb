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
  // The distance kept between two cells, mm; each cell keeps half of it from
  // bones. Twice StepOptions::gap, so that the subsequent steps have room.
  double margin = 0.2;

  // The size of the voxels for the connectivity of a cell, mm. Larger voxels
  // make the preparation of a scene faster, but move muscles farther.
  double voxel_size = 1.5;

  // Surfaces farther away than this do not bound the cell, mm.
  double range = 3;

  // Straight paths between voxels are tested down to segments of this length,
  // mm; they may pass through thinner plates. A plate of 0.25 mm is found
  // (tests/initial_separation/medial_cell_test.cc).
  double thinnest_wall = 0.2;

  bool IsValid(std::string* error) const;
};

// The part of space that belongs to a muscle where delivered meshes overlap:
// all points that are outside all bones and deeper in this muscle than in any
// other. The cells of two overlapping muscles meet at their common medial
// surface, so that both can come to lie on it without pushing each other back
// and forth. A part that a thin bone cuts off from the largest connected part
// does not belong to the cell: the muscle stays on the side of its bulk.
//
//   const MedialCell cell(options, psoas, {&iliacus}, {&femur, &pelvis});
//   const Points apart = cell.Project(psoas.mesh().points());
class MedialCell {
 public:
  // Keeps references to all surfaces. Precondition (CHECKed): the options are
  // valid.
  MedialCell(const MedialCellOptions& options,
             const SolidDistance& muscle,
             std::vector<const SolidDistance*> other_muscles,
             std::vector<const SolidDistance*> bones);

  // Returns the signed distance of a point to the cell, mm: positive by its
  // distance beyond the surface of a bone or a medial surface, negative by its
  // distance from them, which is cut off at the range. The muscle's own surface
  // does not bound the cell. The Lipschitz constant of this function is 1.
  double SignedDistance(const Eigen::RowVector3d& p) const;

  // Returns the signed distance, or -depth where it is below that. A smaller
  // depth takes less time.
  double DistanceDownTo(double depth, const Eigen::RowVector3d& p) const;

  // Returns the signed distance to the region that the muscle may fill: the
  // cell, also bounded by the muscle's own surface. At every point, the sum of
  // these functions of two muscles is at least half the margin.
  double RegionDistance(const Eigen::RowVector3d& p) const;

  // Returns the same with `own` as the distance to the muscle's surface, which
  // may be less than the true one: the region then extends farther within the
  // cell.
  double RegionDistance(const Eigen::RowVector3d& p, double own) const;

  // Returns the unit vector along which the signed distance decreases; zero
  // where no surface is near.
  Eigen::RowVector3d Inward(const Eigen::RowVector3d& p) const;

  // Returns the vertices of the muscle (#V x 3, mm, at the positions of its
  // mesh). Vertices outside the cell, or in a part that is cut off, are moved
  // to the boundary of the cell nearby.
  Points Project(const Points& points) const;

  // Projects the vertices of several muscles. This is faster than one call for
  // each, since work that cannot be divided runs for several muscles at once.
  // Precondition (CHECKed): there are points for every cell.
  static std::vector<Points> Project(
      const std::vector<const MedialCell*>& cells,
      const std::vector<const Points*>& points);

 private:
  struct VoxelGrid;

  // Returns true if all points within `radius` of a point lie in the muscle,
  // and `depth` (mm) or more within the cell.
  bool IsDeepAround(const Eigen::RowVector3d& p,
                    double radius,
                    double depth) const;

  // Returns voxels that cover the muscle with their signed distances to the
  // cell, down to the depth at which paths to neighbours are certainly free.
  VoxelGrid SampledVoxels() const;

  // Finds, for the voxel of each point, the nearest voxel in the largest
  // connected part.
  void FindMainPart(const Points& points, VoxelGrid* grid) const;

  Points Project(const Points& points, const VoxelGrid& grid) const;

  // Returns true if the segment between two points in the cell stays in it.
  // `distance_a` and `distance_b` are the signed distances of the points.
  bool IsPathFree(const Eigen::RowVector3d& a,
                  double distance_a,
                  const Eigen::RowVector3d& b,
                  double distance_b) const;

  // Returns the point where the segment from `q`, in the cell, towards `p`
  // meets the boundary of the cell.
  Eigen::RowVector3d Border(const Eigen::RowVector3d& q,
                            double distance_q,
                            const Eigen::RowVector3d& p) const;

  MedialCellOptions options_;
  const SolidDistance& muscle_;
  std::vector<const SolidDistance*> other_muscles_;
  std::vector<const SolidDistance*> bones_;
};

}  // namespace musclewarp
