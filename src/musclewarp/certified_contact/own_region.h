// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/geometry/mesh_intersection.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

struct OwnRegionOptions {
  double margin = 0.2;  // between two regions and to bones, half each, mm
  double cell = 1.5;    // of the grid that tells what is connected, mm
};

// The part of space that belongs to a muscle where meshes overlap: outside all
// bones, and deeper in the muscle than in any other. Between two muscles that
// overlap it ends at their common mid surface, so that both can go to the same
// place without meeting.
class OwnRegion {
 public:
  // Keeps references to all meshes.
  OwnRegion(const OwnRegionOptions& options,
            const SearchableMesh& muscle,
            std::vector<const SearchableMesh*> other_muscles,
            std::vector<const SearchableMesh*> bones);

  // Above 0: how far `p` is beyond a bone's surface or a mid surface, mm; below
  // 0 how far it is from them (at most 3 mm). The muscle's own surface
  // does not bound it.
  double Excess(const Eigen::RowVector3d& p) const;

  // Where Excess falls, of unit length; zero where there is nothing near.
  Eigen::RowVector3d Inward(const Eigen::RowVector3d& p) const;

  // Vertices of the muscle (#V x 3, in the places of its mesh) that are not in
  // the region, or in a part of it that a bone or muscle cuts off from the
  // main part, are brought to its border near them.
  Points Project(const Points& points) const;

 private:
  struct Grid;
  Grid MainPart() const;
  // Whether the way between two places in the region leads through it.
  bool IsFree(const Eigen::RowVector3d& a,
              double excess_a,
              const Eigen::RowVector3d& b,
              double excess_b) const;

  OwnRegionOptions options_;
  const SearchableMesh& muscle_;
  std::vector<const SearchableMesh*> other_muscles_;
  std::vector<const SearchableMesh*> bones_;
};

}  // namespace musclewarp
