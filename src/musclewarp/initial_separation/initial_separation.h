// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "musclewarp/initial_separation/known_cells.h"
#include "musclewarp/initial_separation/medial_cell.h"
#include "musclewarp/proximity/mesh_intersection.h"
#include "musclewarp/scene/exempt_area.h"

namespace musclewarp {

struct InitialSeparationOptions {
  MedialCellOptions cell;

  // The displacement of a vertex of a crossing triangle in a round, mm.
  double step = 0.3;

  // Vertices within this distance of a pushed vertex move along with it, with a
  // weight that decreases with the distance, mm. Otherwise thin parts would be
  // pushed through themselves.
  double carry_radius = 3;

  // A triangle is pushed along the normal of the triangle that it crosses if
  // that normal agrees with the direction into the medial cell, and otherwise
  // along that direction. They agree if the scalar product of the normal and
  // the sum of the inward directions at the three corners is above this.
  double min_agreement = 0.2;

  // The largest number of rounds. Crossings that remain are accepted.
  int max_rounds = 400;

  // A pair of meshes is idle if at least the share `idle_fraction` of its
  // crossings remains after `idle_rounds` further rounds: separating it would
  // take hundreds of rounds. If all pairs that cross are idle, the rest of the
  // crossings is accepted. Psoas and femur of BodyParts3D (bodyparts3d_thigh)
  // lose a tenth of their crossings in 75 rounds.
  int idle_rounds = 40;
  double idle_fraction = 0.75;

  bool IsValid(std::string* error) const;
};

struct InitialSeparation {
  std::vector<Points> points;  // by muscle, #V x 3, mm
  int rounds = 0;
  int crossing_pairs = 0;  // that remain
};

// Separates meshes that overlap as delivered: returns positions in which no
// triangles of two muscles, or of a muscle and a bone, cross, apart from those
// that remain (crossing_pairs), and from which the rest pose can be relaxed
// (step.h). First the vertices of each muscle move into its medial cell. Then
// only details still cross that poke through triangles between their corners:
// such triangles are pushed farther into their cells, in small steps. Exempt
// areas may still cross their bones.
//
// `on_round`, if given, is called before each round with its number and the
// number of crossing pairs of triangles; it may throw to stop. `cells`, if
// given, saves the cells that are as they were at its last use. Precondition
// (CHECKed): the options are valid.
InitialSeparation SeparateInitially(
    const std::vector<const SearchableMesh*>& muscles,
    const std::vector<const SearchableMesh*>& bones,
    const std::vector<ExemptArea>& exempt,
    const InitialSeparationOptions& options,
    const std::function<void(int round, int crossing_pairs)>& on_round = {},
    KnownCells* cells = nullptr);

}  // namespace musclewarp
