// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "musclewarp/base/infinity.h"

namespace musclewarp {

// The effect of these options was measured on the flexion of the LHDL hip;
// docs/method.md, "Numbers that steer contact", has the figures and the
// command.

// The largest gap that may be kept in a body of human size, mm: beyond, the
// steps in which surfaces move would have to be longer, too.
constexpr double kLargestGap = 0.5;

// Options of the search for separating planes between two triangles, or a
// triangle and a bone (separating_planes.h, bone_planes.h).
struct PlaneSearchOptions {
  // The search covers surfaces whose distance is at most the gap plus this
  // fraction of the largest possible approach (the reach of each muscle). Few
  // vertices move that far, and the exact test of a step finds the remaining
  // crossings. With 1 a step takes a fifth more time, with 0.4 a tenth less, to
  // the same result.
  double search_fraction = 0.7;

  // A part of a bone that protrudes above the plane of a nearer part by at most
  // this fraction of the gap gets no plane of its own. With 0 a step takes a
  // tenth more time.
  double overlooked_fraction = 0.25;

  // The largest number of planes between a triangle and one bone, nearest
  // first. A triangle over a flat part of a bone gets one plane, in a rugged
  // pit several; 12 give the same result.
  int max_planes_per_triangle = 24;

  // The planes of a bone are found for this much more than the distance that
  // matters in a step, mm, and stay until the triangle has moved by as much in
  // the frame of the bone. With 0 a triangle that moves gets new planes in
  // every step.
  double kept_slack = 0.25;

  // Two triangles of one muscle get a plane if their distance is at most
  // `sheet_distance`, mm, and they face each other: the cosines of the angles
  // between their normals and that of the plane exceed `min_facing`. Such
  // triangles are the two sides of a crease or of a thin part. Without these
  // planes creases of the deltoid cross themselves in every round of a step,
  // and its flexion by 60 degrees fails (bodyparts3d_shoulder).
  double sheet_distance = 0.8;
  double min_facing = 0.5;

  bool IsValid(std::string* error) const;
};

// Options of the relaxation of offsets between the planes (Relax).
struct RelaxationOptions {
  // The decay length of an offset around a contact, mm: the length l of the
  // energy in docs/method.md. A shorter one makes single vertices move farther
  // and more triangles fold; a longer one moves the whole muscle more.
  double smoothing_length = 12;

  // How much stiffer an edge becomes with the strain of the offset along it, so
  // that a push at one point is shared by more of the surface: the weight of an
  // edge grows by this times the square of the strain. 0: no edge does.
  double strain_hardening = 16;

  // An edge that is longer than `stretch_limit` times its length at rest, and
  // longer than in the shape of the coarse mesh, pulls its ends together as a
  // taut rope does, with `rope_factor` times its weight. A factor of 0: no edge
  // does.
  double stretch_limit = 1.4;
  double rope_factor = 10;

  // Contact takes volume from a muscle. In every sweep a pressure pushes all
  // vertices outward that would restore this fraction of what is missing if
  // nothing were in the way. Without it (0) the volume comes back where nothing
  // touches the muscle, at the tips of popliteus for example, which are blown
  // up to four times their length. Above 1 the pressure overshoots.
  double pressure_gain = 0.4;

  // Every `full_sweep_interval` sweeps, and in the last one, a vertex tests all
  // its planes; in the other sweeps only those that were near in the last full
  // sweep. Testing all of them in every sweep takes longer without a visible
  // difference.
  int full_sweep_interval = 12;

  // The levels of planes between muscles follow the muscles in every
  // `level_interval`-th sweep. In every sweep takes longer, and is no better
  // (docs/performance.md).
  int level_interval = 2;

  // The largest distance of a vertex from its prediction, mm. It bounds the
  // effect of planes that cannot be satisfied together. Steps are shortened
  // long before (motion/step_length.h).
  double max_push = 5;

  // Before each sweep, the shift of a plane that no side violates any more is
  // multiplied by this factor.
  double room_decay = 0.97;

  // A plane counts as not violated if the violations of both sides add up to
  // less than this, mm.
  double room_tolerance = 1e-3;

  // A vertex whose half-spaces have no common point within `max_push` moves to
  // a compromise between them: one millimetre of the worst violation weighs as
  // much as `violation_weight` millimetres of motion
  // (CompromiseBetweenHalfSpaces). From there it approaches the half-spaces of
  // bones, which do not yield, in at most `bone_turns` rounds
  // (ApproachHalfSpaces). The planes that it violates are shifted, so that the
  // muscles beyond them yield.
  double violation_weight = 10;
  int bone_turns = 20;

  // A vertex at most this far above a plane, mm, is in contact with it when the
  // rows of the coarse solve are selected (PlaneSet::MostViolated).
  double contact_distance = 0.5;

  bool IsValid(std::string* error) const;
};

// Options of the restoration of the volume of a muscle within its half-spaces
// (RestoreVolumes).
struct VolumeOptions {
  // The tolerance of the volume, relative.
  double tolerance = 1e-8;

  // The largest number of Newton steps. If planes hold most of a muscle, 20
  // steps leave an error of 2.5e-5 (hamstrings), 40 reach the tolerance.
  int max_steps = 40;

  // The largest distance by which the restoration moves a vertex, mm. Of a
  // muscle between others only the rim is free, from which the volume that they
  // withhold would grow as a flap. What then is still missing is withheld
  // (ContactState). Of the steps of a motion, which have to keep the volume, it
  // is infinite.
  double max_move = kInfinity;

  // Smoothing passes over the weights of vertices in the restoration, so that
  // no visible edge forms around vertices held by a plane or a bone.
  int smoothing_passes = 3;

  bool IsValid(std::string* error) const;
};

// Options of the repair of crossing and folded triangles in the rounds of a
// step (defects.h).
struct DefectOptions {
  // The gap between two sheets of one muscle, as a fraction of their distance
  // before the step; at most the gap between surfaces.
  double sheet_fraction = 0.5;

  // The stiffness of folded and self-crossing triangles is multiplied by this
  // factor, up to the limit, so that they move as one piece in the next round.
  double stiffening = 10;
  double max_stiffness = 1e4;

  // A folded triangle keeps at least this fraction of its height at rest.
  double unfolded_height = 0.1;

  // The admissible fraction of folded triangles of a muscle; above it they are
  // unfolded. The certificate admits twice as many.
  double max_folded_fraction = 5e-4;

  bool IsValid(std::string* error) const;
};

// All options of one step of certified contact.
struct StepOptions {
  // The smallest distance between two surfaces, mm. A larger gap displaces
  // muscles farther. The default of every program.
  double gap = 0.1;

  // The largest distance by which a sweep moves a vertex from its prediction,
  // before the projection, mm. Surfaces farther apart than the gap plus twice
  // the reach get no plane. A larger reach makes a step slower, as more planes
  // are needed; a smaller one displaces vertices farther in the end.
  double reach = 1;

  // The numbers of Gauss-Seidel sweeps over all vertices: before the exact test
  // of the first round, and in each later round. With 48 sweeps a step takes a
  // third more time, with 12 a tenth less, to the same result.
  int sweeps = 24;
  int repair_sweeps = 10;

  // The largest number of rounds of sweeps and exact tests in a step. The LHDL
  // hip needs 3.
  int max_rounds = 6;

  // The largest number of further rounds in which a step without crossings
  // unfolds triangles and reduces violations of planes.
  int max_polishing_rounds = 2;

  // If true, the step unfolds crumpled muscles: the two sides of a muscle may
  // pass through each other, and rounds repair crossings of two meshes only.
  bool unfolds = false;

  PlaneSearchOptions planes;
  RelaxationOptions relaxation;
  VolumeOptions volume;
  DefectOptions defects;

  // The gap of the planes, mm: larger than `gap`, so that overlooked parts of a
  // bone still keep the gap and small violations of planes are harmless.
  double AimedGap() const { return gap / (1 - planes.overlooked_fraction); }

  // The admissible violation of a plane at the end of a step, mm: half of the
  // margin above `gap`, as both of two muscles may violate a plane.
  double AllowedViolation() const { return (AimedGap() - gap) / 2; }

  // Also checks the nested options.
  bool IsValid(std::string* error) const;
};

}  // namespace musclewarp
