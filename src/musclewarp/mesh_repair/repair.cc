// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mesh_repair/repair.h"

#include <glog/logging.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "musclewarp/base/input_error.h"
#include "musclewarp/base/invalid_option.h"
#include "musclewarp/base/text.h"
#include "musclewarp/mesh/connectivity.h"
#include "musclewarp/mesh/defects.h"
#include "musclewarp/mesh/measures.h"
#include "musclewarp/mesh_repair/orientation.h"

namespace musclewarp {
namespace {

void PullApartUntilClear(TriangleSoup* soup, RepairReport* report) {
  constexpr int kMaxRounds = 5;  // a pull may land on another point
  for (int round = 0; round < kMaxRounds; ++round) {
    const Pulls pulls = PullApart(soup);
    if (pulls.points == 0) return;
    report->pulls.points += pulls.points;
    report->pulls.longest = std::max(report->pulls.longest, pulls.longest);
  }
}

void CheckTwoSided(const Flips& flips,
                   double body_size,
                   const std::string& name) {
  if (flips.conflicts == 0) return;
  throw InputError(name,
                   "the surface has one side only (" +
                       std::to_string(flips.conflicts) +
                       " edges contradict each other, one at " +
                       PlaceText(flips.conflict, body_size) + ")",
                   "cut the twisted strip out of the mesh");
}

void CheckClosed(const TriangleSoup& soup,
                 const HoleLimits& limits,
                 double body_size,
                 const std::string& name) {
  const auto loops = FindBorderLoops(soup.triangles);
  if (loops.empty()) return;
  const auto longest = *std::max_element(
      loops.begin(), loops.end(), [&](const auto& a, const auto& b) {
        return LoopLength(a, soup.points) < LoopLength(b, soup.points);
      });
  Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
  for (const int v : longest) centre += soup.points.row(v) / longest.size();
  std::ostringstream problem;
  problem << "an open border of " << longest.size() << " edges, "
          << LengthText(LoopLength(longest, soup.points), body_size)
          << " long, around " << PlaceText(centre, body_size) << " remains";
  if (loops.size() > 1) problem << " and " << loops.size() - 1 << " smaller";
  problem << "; allowed: holes of up to "
          << LengthText(limits.max_perimeter, body_size)
          << " or narrow slits of any length, with up to " << limits.max_edges
          << " edges, and any of up to " << limits.face_edges << " edges";
  throw InputError(name,
                   problem.str(),
                   "close the surface, or allow longer holes ({max_hole})");
}

void CheckClean(const TriangleSoup& soup, const std::string& name) {
  const MeshDefects defects = CountDefects(soup);
  if (defects.IsCleanInPieces()) return;
  std::ostringstream problem;
  problem << "no closed surface could be made of it: " << soup.triangles.rows()
          << " triangles are left, with " << defects.non_manifold_edges
          << " non-manifold edges, " << defects.non_manifold_vertices
          << " non-manifold vertices, " << defects.duplicate_triangles
          << " duplicate and " << defects.degenerate_triangles
          << " degenerate triangles, " << defects.duplicate_points
          << " points on others";
  throw InputError(name, problem.str(), "repair the mesh in a mesh editor");
}

}  // namespace

bool RepairReport::AnythingDone() const {
  return point_merges.merged + degenerate_triangles + duplicate_triangles +
                 flipped_triangles + separation.edges + separation.copies +
                 stitches.merged_points + stitches.inserted_points +
                 fillings.holes + separated_vertices + pulls.points +
                 dropped_points >
             0 ||
         !dropped_pieces.empty();
}

bool RepairOptions::IsValid(std::string* error) const {
  const auto fail = [error](const std::string& field,
                            double value,
                            const std::string& allowed) {
    return InvalidOption("RepairOptions::" + field, value, allowed, error);
  };
  if (!(merge_tolerance >= 0 && merge_tolerance < 1)) {
    return fail("merge_tolerance", merge_tolerance, "0 or above, below 1");
  }
  if (!(stitch_tolerance >= 0)) {
    return fail("stitch_tolerance", stitch_tolerance, "0 or above");
  }
  return pieces.IsValid(error) && holes.IsValid(error);
}

TriangleSoup RepairMesh(const TriangleSoup& soup,
                        const std::string& name,
                        const RepairOptions& options,
                        RepairReport* report) {
  std::string error;
  CHECK(options.IsValid(&error)) << error;
  RepairReport unused;
  if (report == nullptr) report = &unused;
  *report = RepairReport();
  if (CountDefects(soup).IsClean()) return soup;

  TriangleSoup work = soup;
  report->point_merges = MergePoints(
      options.merge_tolerance * BoundingBoxDiagonal(work.points), &work);
  report->degenerate_triangles = RemoveDegenerateTriangles(&work);
  report->duplicate_triangles = RemoveDuplicateTriangles(&work.triangles);
  const Flips flips = OrientConsistently(&work);
  CheckTwoSided(flips, options.body_size, name);
  report->flipped_triangles = flips.flipped;
  report->separation = SeparateAtNonManifoldEdges(&work);
  report->stitches = StitchBorders(options.stitch_tolerance, &work);
  DropCrumbs(options.pieces, &work, &report->dropped_pieces);
  report->fillings = FillHoles(options.holes, &work);
  report->separated_vertices = SeparateAtNonManifoldVertices(&work);
  KeepSurfaces(options.pieces, &work, &report->dropped_pieces);
  CheckClosed(work, options.holes, options.body_size, name);
  // The surfaces are closed now: each is turned as a whole or not at all.
  report->flipped_triangles += OrientConsistently(&work).flipped;
  report->dropped_points = DropUnreferencedPoints(&work);
  PullApartUntilClear(&work, report);
  CheckClean(work, name);
  report->pieces = CountDefects(work).components;
  return work;
}

}  // namespace musclewarp
