// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "musclewarp/base/described.h"
#include "musclewarp/figures/shape_figures.h"
#include "musclewarp/solver/solver_summary.h"

namespace musclewarp {

// Every number that is known of a muscle in one pose: an entry of "muscles" in
// a frame of report.json.
struct MuscleFigures {
  std::string name;

  // The volume of the fine mesh, mm^3, and that against the volume of the mesh
  // as it was delivered (MeshPreparation::delivered_volume).
  double volume = 0;
  double volume_ratio = 0;

  // How far the volume is off the one that the solver keeps, that of the mesh
  // at rest, as a share of it: an error of the solver. What the preparation
  // took is in the ratio.
  double volume_error = 0;
  double max_displacement = 0;  // of a fine vertex from rest, mm

  // The smallest distance of a vertex to another mesh, mm, negative inside one;
  // at most kGapLimit.
  double min_gap = 0;
  int folded_triangles = 0;
  int self_pairs = 0;  // of triangles that cross each other

  // With certified contact: how far contact moved a fine vertex, at most and on
  // average, and how deep the muscle is in another mesh, or another in it,
  // without contact, mm.
  double max_contact_displacement = 0;
  double mean_contact_displacement = 0;
  double depth_without_contact = 0;

  // The largest patch of its surface that contact has torn.
  SurfacePatch torn_patch;

  // The depths of all overlaps without contact along the chain of muscles that
  // push this one, mm, and these muscles; this one comes last. What its
  // displacement is judged by.
  double push_depth = 0;
  std::vector<std::string> pushed_by;

  // How far each attachment area has left its body.
  std::vector<AttachmentDrift> attachments;

  // What the pose does to its shape.
  ShapeMeasures shape;

  SolverSummary solver;

  // The lengths of the action lines by name, mm: as the muscle carries them,
  // and straight through their path points. And those of the fibres.
  std::map<std::string, double> line_lengths;
  std::map<std::string, double> path_lengths;
  std::vector<double> fibre_lengths;

  // StretchByFifths; empty without fibres.
  std::vector<double> fibre_stretch_by_fifths;

  // -dl/dq as the muscle carries them, mm/rad (or mm/m): of lines by name and
  // coordinate, of fibres by coordinate, without coordinates that move no
  // fibre. There are none without a model, nor with the paper's contact, which
  // ends in no minimum that could be differentiated.
  std::map<std::string, std::map<std::string, double>> line_moment_arms;
  std::map<std::string, std::vector<double>> fibre_moment_arms;
};

constexpr auto FieldsOf(Described<MuscleFigures>) {
  using F = MuscleFigures;
  return std::make_tuple(
      Field(&F::name, "name", "", "the muscle"),
      Field(&F::volume, "volume_mm3", "mm3", "of the fine mesh"),
      Field(&F::volume_ratio,
            "volume_ratio",
            "",
            "volume of the fine mesh over `delivered_volume_mm3`: pieces that "
            "the repair left out count as lost"),
      Field(&F::volume_error,
            "volume_error",
            "",
            "how far the volume is off the one that the solver keeps, that of "
            "the mesh at rest, as a share of it. It differs from "
            "`volume_ratio` - 1 where the preparation changed the volume "
            "(`remade`, removed slivers, pieces left out)"),
      Field(Inner(&F::solver, &SolverSummary::max_step),
            "max_step_mm",
            "mm",
            "largest vertex move of the last iteration"),
      Field(&F::max_displacement,
            "max_displacement_mm",
            "mm",
            "largest distance of a fine vertex from its rest position")
          .AtLeast(0),
      Field(&F::min_gap,
            "min_gap_mm",
            "mm",
            "the smallest gap of a vertex to another mesh, negative inside, at "
            "most 5 (times `body_size`)"),
      Field(&F::folded_triangles,
            "folded_triangles",
            "",
            "triangles whose normal points against the rest normal turned with "
            "its surroundings (two rings)")
          .AtLeast(0),
      Field(&F::self_pairs,
            "self_pairs",
            "",
            "pairs of triangles of this muscle that cross each other")
          .AtLeast(0),
      Field(&F::max_contact_displacement,
            "max_contact_displacement_mm",
            "mm",
            "with `--contact=certified`: how far contact moved a fine vertex "
            "from the shape without contact, at most")
          .AtLeast(0),
      Field(&F::mean_contact_displacement,
            "mean_contact_displacement_mm",
            "mm",
            "the same on average")
          .AtLeast(0),
      Field(&F::depth_without_contact,
            "depth_without_contact_mm",
            "mm",
            "with `--contact=certified`: in the shapes without contact, depth "
            "of the deepest vertex of this muscle in another mesh, or of "
            "another mesh in this muscle")
          .AtLeast(0),
      Field(Inner(&F::torn_patch, &SurfacePatch::area),
            "torn_patch_mm2",
            "mm2",
            "with `--contact=certified`: area at rest of the largest patch of "
            "the surface that contact has torn: triangles stretched beyond 2, "
            "and by 0.2 more than without contact")
          .AtLeast(0),
      Field(Inner(&F::torn_patch, &SurfacePatch::place),
            "torn_patch_place_mm",
            "mm",
            "the centre of that patch"),
      Field(&F::push_depth,
            "push_depth_mm",
            "mm",
            "with `--contact=certified`: the depths without contact along the "
            "chain of muscles that may push this one farthest, added up")
          .AtLeast(0),
      Field(&F::pushed_by,
            "pushed_by",
            "",
            "the names of these muscles; the last one is this muscle"),
      Field(&F::attachments,
            "attachments",
            "",
            "how far each attachment area has left its body"),
      Field(&F::shape,
            "shape",
            "",
            "what the pose does to the surface of the muscle, each where it is "
            "largest"),
      Field(Inner(&F::solver, &SolverSummary::iterations),
            "iterations",
            "",
            "of the solver"),
      Field(Inner(&F::solver, &SolverSummary::wall_ms),
            "solve_ms",
            "ms",
            "time in the solver"),
      Field(Inner(&F::solver, &SolverSummary::initial_energy),
            "initial_energy_mm2",
            "mm2",
            "the linear energy at the start, half the squared length of f"),
      Field(Inner(&F::solver, &SolverSummary::final_energy),
            "final_energy_mm2",
            "mm2",
            "the same at the end"),
      Field(Inner(&F::solver, &SolverSummary::stop_reason),
            "stop_reason",
            "",
            "`converged`, or why the solver stopped before that"),
      Field(&F::line_lengths,
            "line_lengths_mm",
            "mm",
            "of the lines as the muscle carries them, by name"),
      Field(&F::path_lengths,
            "path_lengths_mm",
            "mm",
            "of the straight paths through the path points in this pose"),
      Field(&F::fibre_lengths, "fibre_lengths_mm", "mm", "with `--fibres`"),
      Field(&F::fibre_stretch_by_fifths,
            "fibre_stretch_by_fifths",
            "",
            "with `--fibres`: by which factor each fifth of the length, from "
            "the origin on, is longer than at rest, the mean over the fibres"),
      Field(&F::line_moment_arms,
            "line_moment_arms_mm",
            "mm/rad",
            "-dl/dq of the lines as the muscle carries them, by line and "
            "coordinate (mm/m for translations): [exact derivatives]"
            "(method.md#moment-arms-solvershape_derivativeh-"
            "framesmoment_armsh) of `line_lengths_mm`. Empty without a model, "
            "and with `--contact=paper`"),
      Field(&F::fibre_moment_arms,
            "fibre_moment_arms_mm",
            "mm/rad",
            "with `--fibres`: the same, a list for each coordinate. A "
            "coordinate that changes no fibre is left out"),
      NotWritten(&F::solver),
      NotWritten(&F::torn_patch));
}

}  // namespace musclewarp
