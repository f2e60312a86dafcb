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
// a frame of report.json. The list below says what each is, lengths are in mm.
struct MuscleFigures {
  std::string name;
  double volume = 0;
  double volume_ratio = 0;  // to MeshPreparation::delivered_volume
  double volume_error = 0;
  double max_displacement = 0;
  double min_gap = 0;  // at most kGapLimit
  int folded_triangles = 0;
  int self_pairs = 0;
  double max_bone_push = 0;
  double max_contact_displacement = 0;
  double mean_contact_displacement = 0;
  double depth_without_contact = 0;
  SurfacePatch torn_patch;
  double push_depth = 0;
  std::vector<std::string> pushed_by;
  std::vector<AttachmentDrift> attachments;
  ShapeMeasures shape;
  SolverSummary solver;

  // By name; by number, of fibres.
  std::map<std::string, double> line_lengths;
  std::map<std::string, double> path_lengths;
  std::vector<double> fibre_lengths;
  std::vector<double> fibre_stretch_by_fifths;  // StretchByFifths()

  // By line and coordinate, and by coordinate and fibre. There are none with
  // the paper's contact, which ends in no minimum that could be differentiated.
  std::map<std::string, std::map<std::string, double>> line_moment_arms;
  std::map<std::string, std::vector<double>> fibre_moment_arms;
};

constexpr auto FieldsOf(Described<MuscleFigures>) {
  using F = MuscleFigures;
  return std::make_tuple(
      Field(&F::name, "name").Text("name of the muscle"),
      Field(&F::volume, "volume_mm3", "mm3").Text("volume of the fine mesh"),
      Field(&F::volume_ratio, "volume_ratio")
          .Text("volume of the fine mesh over `delivered_volume_mm3`: pieces "
                "that the repair left out count as lost"),
      Field(&F::volume_error, "volume_error")
          .Text("how far the volume is off the one that the solver keeps, that "
                "of the mesh at rest, as a share of it. It differs from "
                "`volume_ratio` - 1 where the preparation changed the volume "
                "(`remade`, removed slivers, pieces left out)"),
      Field(Inner(&F::solver, &SolverSummary::max_step), "max_step_mm", "mm")
          .Text("largest vertex move of the last iteration"),
      Field(&F::max_displacement, "max_displacement_mm", "mm")
          .Text("largest distance of a fine vertex from its rest position")
          .AtLeast(0),
      Field(&F::min_gap, "min_gap_mm", "mm")
          .Text("the smallest gap of a vertex to another mesh, negative "
                "inside, at most 5 (times `body_size`)"),
      Field(&F::folded_triangles, "folded_triangles")
          .Text("triangles whose normal points against the rest normal turned "
                "with its surroundings (two rings)")
          .AtLeast(0),
      Field(&F::self_pairs, "self_pairs")
          .Text("pairs of triangles of this muscle that cross each other")
          .AtLeast(0),
      Field(&F::max_bone_push, "max_bone_push_mm", "mm")
          .Text("how far bones pushed a fine vertex of the shape without "
                "contact aside, at most")
          .AtLeast(0)
          .Later(),
      Field(&F::max_contact_displacement, "max_contact_displacement_mm", "mm")
          .Text("with `{contact}=certified`: how far contact moved a fine "
                "vertex from the shape without contact, at most")
          .AtLeast(0),
      Field(&F::mean_contact_displacement, "mean_contact_displacement_mm", "mm")
          .Text("the same on average")
          .AtLeast(0),
      Field(&F::depth_without_contact, "depth_without_contact_mm", "mm")
          .Text("with `{contact}=certified`: in the shapes without contact, "
                "depth of the deepest vertex of this muscle in another mesh, "
                "or of another mesh in this muscle")
          .AtLeast(0),
      Field(Inner(&F::torn_patch, &SurfacePatch::area), "torn_patch_mm2", "mm2")
          .Text("with `{contact}=certified`: area at rest of the largest patch "
                "of the surface that contact has torn: triangles stretched "
                "beyond 2, and by 0.2 more than without contact")
          .AtLeast(0),
      Field(Inner(&F::torn_patch, &SurfacePatch::place),
            "torn_patch_place_mm",
            "mm")
          .Text("the centre of that patch"),
      Field(&F::push_depth, "push_depth_mm", "mm")
          .Text(
              "with `{contact}=certified`: the depths without contact along "
              "the chain of muscles that may push this one farthest, added up")
          .AtLeast(0),
      Field(&F::pushed_by, "pushed_by")
          .Text("the names of these muscles; the last one is this muscle"),
      Field(&F::attachments, "attachments")
          .Text("how far each attachment area has left its body"),
      Field(&F::shape, "shape")
          .Text("what the pose does to the surface of the muscle, each where "
                "it is largest"),
      Field(Inner(&F::solver, &SolverSummary::iterations), "iterations")
          .Text("iterations of the solver"),
      Field(Inner(&F::solver, &SolverSummary::wall_ms), "solve_ms", "ms")
          .Text("time in the solver"),
      Field(Inner(&F::solver, &SolverSummary::initial_energy),
            "initial_energy_mm2",
            "mm2")
          .Text("the linear energy at the start, half the squared length of f"),
      Field(Inner(&F::solver, &SolverSummary::final_energy),
            "final_energy_mm2",
            "mm2")
          .Text("the same at the end"),
      Field(Inner(&F::solver, &SolverSummary::stop_reason), "stop_reason")
          .Text("`converged`, or why the solver stopped before that"),
      Field(&F::line_lengths, "line_lengths_mm", "mm")
          .Text("lengths of the lines as the muscle carries them, by name"),
      Field(&F::path_lengths, "path_lengths_mm", "mm")
          .Text("lengths of the straight paths through the path points in this "
                "pose, by name"),
      Field(&F::fibre_lengths, "fibre_lengths_mm", "mm")
          .Text("with `{fibres}`: lengths of the fibres"),
      Field(&F::fibre_stretch_by_fifths, "fibre_stretch_by_fifths")
          .Text("with `{fibres}`: by which factor each fifth of the length, "
                "from the origin on, is longer than at rest, the mean over the "
                "fibres"),
      Field(&F::line_moment_arms, "line_moment_arms_mm", "mm/rad")
          .Text("-dl/dq of the lines as the muscle carries them, by line and "
                "coordinate (mm/m for translations): [exact "
                "derivatives](method.md#moment-arms-solvershape_derivativeh-"
                "framesmoment_armsh) of `line_lengths_mm`. Empty without a "
                "model, and with `{contact}=paper`"),
      Field(&F::fibre_moment_arms, "fibre_moment_arms_mm", "mm/rad")
          .Text("with `{fibres}`: the same, a list for each coordinate. A "
                "coordinate that changes no fibre is left out"),
      NotWritten(&F::solver),
      NotWritten(&F::torn_patch));
}

}  // namespace musclewarp
