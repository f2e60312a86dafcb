// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "musclewarp/initial_separation/medial_cell.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/scene/exempt_area.h"

namespace musclewarp {

struct InitialSeparationOptions {
  MedialCellOptions cell;

  // How far a vertex of a crossing triangle moves in a round, mm.
  double step = 0.3;

  // Vertices nearer than this to one that is pushed go along with it, the less
  // the farther they are, mm. Without it thin parts would be pushed through
  // themselves.
  double carry_radius = 3;

  // A triangle is pushed along the normal of the one that it crosses if that
  // agrees with the way into the medial cell, and else along that way. They
  // agree if the scalar product of the normal with the sum of the directions at
  // the three corners is above this.
  double min_agreement = 0.2;

  // Rounds before what still crosses is left.
  int max_rounds = 400;

  // A pair of meshes of whose crossings more than this share is left after so
  // many further rounds would take hundreds. If all that cross are such, the
  // rest is left, too. Psoas and femur of BodyParts3D (bodyparts3d_thigh) lose
  // a tenth of their crossings in 75 rounds.
  int idle_rounds = 40;
  double idle_fraction = 0.75;

  bool IsValid(std::string* error) const;
};

struct InitialSeparation {
  std::vector<Points> points;  // by muscle, #V x 3, mm
  int rounds = 0;
  int crossing_pairs = 0;  // that are left
};

// Separates meshes that overlap as they are delivered: returns positions in
// which no triangles of two muscles, or of a muscle and a bone, cross, from
// which the rest pose can be relaxed (step.h). First the vertices of each
// muscle go into its medial cell. Then only details that poke through triangles
// between their corners still cross: those triangles are pushed farther into
// their cells, in small steps. Exempt areas stay where they are.
//
// `on_round`, if given, is called before each round with its number and the
// pairs of triangles that cross; it may throw to stop. Precondition (CHECKed):
// the options are valid.
InitialSeparation SeparateInitially(
    const std::vector<const SearchableMesh*>& muscles,
    const std::vector<const SearchableMesh*>& bones,
    const std::vector<ExemptArea>& exempt,
    const InitialSeparationOptions& options,
    const std::function<void(int round, int crossing_pairs)>& on_round = {});

}  // namespace musclewarp
