// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace musclewarp {

// What the fields of these structs are worth was measured on the flexion of the
// LHDL hip; docs/method.md, "Numbers that steer contact", has the figures and
// the command.

// How separating planes are looked for between two triangles, or a triangle and
// a bone (FindSeparatingPlanes).
struct PlaneSearchOptions {
  // Planes are looked for between surfaces whose distance is at most the gap
  // plus this part of the way that both may go towards each other (the reach of
  // each). Few vertices go that far, and crossings beyond are found by the
  // exact test of a step. With 1 a step takes a fifth more time, with 0.4 a
  // tenth less, to the same result.
  double search_fraction = 0.7;

  // A part of a bone that pokes above the plane of a nearer part by no more
  // than this share of the gap gets no plane of its own. With 0 a step takes a
  // tenth more time.
  double overlooked_fraction = 0.25;

  // The most planes between a triangle and one bone, nearest first. A triangle
  // over a flat part of a bone has one, in a rugged pit it has several; 12 give
  // the same result.
  int max_planes_per_triangle = 24;

  // Two triangles of one muscle get a plane if they are at most so far apart,
  // mm, and face each other: the normals of both make an angle with the plane's
  // whose cosine is above this. These are the two sides of a crease, or of a
  // thin part. Without them creases of the deltoid cross themselves in every
  // round of a step, and its flexion by 60 degrees fails
  // (bodyparts3d_shoulder).
  double sheet_distance = 0.8;
  double min_facing = 0.5;

  bool IsValid(std::string* error) const;
};

// How the offsets of vertices from their targets are relaxed between the planes
// (Relax).
struct RelaxationOptions {
  // How fast an offset dies away beside the place where contact asks for it,
  // mm: the length l of the energy in docs/method.md. With a shorter one single
  // vertices move farther and more triangles fold; with a longer one the whole
  // muscle moves more.
  double smoothing_length = 8;

  // Every so many sweeps, and in the last one, a vertex looks at all its
  // planes; in the sweeps between at those alone that were near the last time.
  // Looking at all of them in each sweep takes longer and changes nothing that
  // shows.
  int full_sweep_interval = 6;

  // No vertex is pushed farther than this from where it is carried to, mm. It
  // keeps planes that cannot be satisfied together from throwing a vertex far
  // away. Steps are made shorter long before (motion/step_length.h).
  double max_push = 5;

  // After each sweep, a muscle keeps this share of the room that another one
  // gave it and that it does not need any more.
  double room_decay = 0.97;

  // A muscle that reaches less than this far into the other's side of a plane,
  // mm, does not need that room.
  double room_tolerance = 1e-3;

  // A vertex whose half-spaces have no common point so near is put between
  // them: a millimetre of the worst violation counts as so many of the way
  // (CompromiseBetweenHalfSpaces). From there it goes towards those of bones,
  // which do not give way, in so many turns (ApproachHalfSpaces). The planes
  // that it violates are shifted, so that what is beyond them gives way.
  double violation_weight = 10;
  int bone_turns = 20;

  // A vertex nearer to a plane than this, mm, counts as one that the plane
  // holds when rows for the coarse solve are chosen.
  double contact_distance = 0.5;

  bool IsValid(std::string* error) const;
};

// How a step restores the volume of a muscle inside its half-spaces
// (RestoreVolume).
struct VolumeOptions {
  // The volume error that is allowed to remain, relative.
  double tolerance = 1e-8;

  // Newton steps before the rest of the error is left. Where planes hold most
  // of a muscle 20 leave 2.5e-5 (hamstrings), 40 reach the tolerance.
  int max_steps = 40;

  // Rounds of averaging over neighbours by which vertices beside one that is
  // held take part less, so that no edge shows there.
  int smoothing_passes = 3;

  bool IsValid(std::string* error) const;
};

// What a step does about triangles that still cross or that fold (defects.h).
struct DefectOptions {
  // Two sheets of a muscle that crossed are kept apart by this share of their
  // distance before the step, at most by the gap.
  double sheet_fraction = 0.5;

  // The edge weights of triangles of one muscle that cross or fold grow by this
  // factor, up to the limit, so that they move as one piece in the next round.
  double stiffening = 10;
  double max_stiffness = 1e4;

  // A triangle that folded is kept at this share of the height that its target
  // has.
  double unfolded_height = 0.1;

  // A muscle may have this share of its triangles folded before they are
  // unfolded. The certificate allows twice as many.
  double max_folded_fraction = 5e-4;

  bool IsValid(std::string* error) const;
};

// All numbers that steer one step of certified contact.
struct StepOptions {
  // The distance that two surfaces keep at least, mm. Muscles move farther the
  // larger it is. The default of every program.
  double gap = 0.1;

  // How far a vertex may move in one step beside the way that it is carried
  // along with its muscle, mm. Surfaces that are farther apart than the gap and
  // twice the reach get no plane. With more reach a step takes longer, as there
  // are more planes; with less, vertices are moved farther in the end.
  double reach = 1;

  // Gauss-Seidel sweeps over all vertices: before the exact test of the first
  // round, and in each later round. With 48 sweeps a step takes a third more
  // time, with 12 a tenth less, to the same result.
  int sweeps = 24;
  int repair_sweeps = 10;

  // Rounds of sweeps and exact tests before a step is given up. 3 are enough
  // for the LHDL hip.
  int max_rounds = 6;

  // Rounds in which a step without crossings tries to unfold triangles and to
  // bring vertices back to their planes before the best of them is taken.
  int max_polishing_rounds = 2;

  PlaneSearchOptions planes;
  RelaxationOptions relaxation;
  VolumeOptions volume;
  DefectOptions defects;

  // The gap that planes aim at, mm: larger, so that parts of a bone that are
  // overlooked still keep the gap, and that small violations of planes do not
  // count.
  double AimedGap() const { return gap / (1 - planes.overlooked_fraction); }

  // By how much a vertex may be beyond its plane at the end of a step, mm. As
  // two muscles share the gap between them, it is half of what is to spare.
  double AllowedViolation() const { return (AimedGap() - gap) / 2; }

  // Also checks the options within.
  bool IsValid(std::string* error) const;
};

}  // namespace musclewarp
