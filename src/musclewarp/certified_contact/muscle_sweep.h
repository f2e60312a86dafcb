// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/plane_set.h"
#include "musclewarp/certified_contact/step_options.h"
#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// Projected Gauss-Seidel sweeps over one muscle (relaxation.h), block by block
// (vertex_blocks.h). All data are in the order of the blocks, so that a sweep
// passes once through memory.
//
//   MuscleSweep muscle(options, step, i, targets, stiffness, points);
//   muscle.UpdateGradient(points);
//   muscle.SetPressure(gain);
//   for each block b: muscle.SweepBlock(b, {}, &planes, &points, &before);
//
// SweepBlock() may be called concurrently for blocks of one colour.
class MuscleSweep {
 public:
  // Starts at `points`. #V x 3 each, mm; `stiffness`: #V.
  MuscleSweep(const StepOptions& options,
              const ContactStep& step,
              int muscle,
              const Points& targets,
              const Eigen::VectorXd& stiffness,
              const Points& points);

  // Finds the gradient of the volume at `points`, those of the last sweep.
  void UpdateGradient(const Points& points);

  // Sets the pressure that restores a fraction `gain` of the volume that is
  // missing, as far as the last gradient tells, if nothing is in the way.
  void SetPressure(double gain);

  // What the sweeps over the blocks have to know of planes.
  struct PlaneChanges {
    bool looks_at_all = true;  // each vertex selects those that are near
    bool levels_moved = true;  // since the last sweep
  };

  // Moves each vertex of a block to its lowest place and projects it into its
  // half-spaces; writes both places of the vertices of the block.
  void SweepBlock(int block,
                  const PlaneChanges& changes,
                  PlaneSet* planes,
                  Points* points,
                  Points* unprojected);

 private:
  // What moves of a vertex, mm.
  struct Place {
    Eigen::RowVector3d offset, point;  // point = target + offset
  };
  // What stays in all sweeps.
  struct Vertex {
    Eigen::RowVector3d target, predicted;  // mm
    double curvature;  // of the energy without edges, and with them
    double full_curvature;
    int number;      // in the muscle
    int attached;    // its row among attached positions; -1 if it has none
    int first_edge;  // in edges_
  };
  // An edge of the energy, seen from one of its ends.
  struct Edge {
    int neighbour;     // by the order of the blocks
    double weight;     // w
    double hardening;  // h / e^2, mm^-2
    double rope;       // s, mm
    double loose;      // the square of a strain that surely does not tauten it
  };

  void AddEdges(const Points& targets, const Eigen::VectorXd& stiffness);
  Eigen::RowVector3d LowestPlace(int i) const;
  Eigen::RowVector3d WithinReach(const Vertex& vertex,
                                 const Eigen::RowVector3d& place) const;

  const StepOptions& options_;
  const MuscleSurface& surface_;
  const Points& attached_;  // positions
  const int muscle_;
  const double reach_;  // mm
  std::vector<Vertex> vertices_;
  std::vector<Edge> edges_;
  std::vector<Place> places_;

  // The gradient of the volume at an earlier sweep, #V x 3, mm^2, and what the
  // volume lacked there beside its part that is linear in the vertices, mm^3.
  Points gradient_;
  double lacking_ = 0;
  double withheld_ = 0;  // ContactState::withheld, mm^3
  double yield_ = 0;  // the volume that a unit of pressure restores in a sweep
  double pressure_ = 0;
};

}  // namespace musclewarp
