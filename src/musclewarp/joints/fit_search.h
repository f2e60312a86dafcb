// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The numbers of fits, of heads and of shafts (joint_search.h).

namespace musclewarp {

// Votes for centres, and fits that start where they meet.
struct FitNumbers {
  // Votes so near to a centre count for it: those of normals within 9 degrees
  // of the radii (radii of the head).
  double vote_tolerance = 0.15;

  // Between radii that are tried: half of what votes tolerate at the smallest
  // head (mm).
  double radius_step = 1;

  // Places that start a sphere of each radius; not measured.
  int peaks_of_sphere = 3;

  // Places that start a circle of each radius; not measured.
  int peaks_of_circle = 5;

  // Points farther from a shape count less: half of the spread of a head on
  // which a fit is good (mm).
  double loss_scale = 0.4;

  // Normals that pass an axis by more count less; not measured (mm).
  double pass_scale = 1;

  // How often the points near a shape are chosen anew, within a tolerance that
  // narrows; not measured.
  int fit_rounds = 6;

  // A fit needs so many: 43 mm2 of surface; not measured.
  int fewest_points = 30;

  // Of a normal and the radius at its point: within 32 degrees (cosine).
  double least_normal = 0.85;

  // Points so near to a sphere or dome belong to it in the last rounds; not
  // measured (mm).
  double sphere_reach = 1.5;
};

// The head of a femur or humerus, and the shaft of a femur.
struct HeadSearch {
  // Radius of the smallest head that is looked for; those of all three persons
  // have 23 mm.
  double least_head_radius = 14;

  // Radius of the largest one; not measured (mm).
  double largest_head_radius = 32;

  // Of a head that is not known: that of LHDL and BodyParts3D (mm).
  double usual_head_radius = 23;

  // Normals of uncertain heads are averaged over this: the head of 3 mm voxels
  // then covers 55 % in place of 25 %, and the next best place no more than
  // before (mm).
  double coarse_normals = 5;

  // A head that covers less is uncertain: whole ones of all three persons
  // cover 58 to 64 % (%).
  double uncertain_coverage = 50;

  // Least radius of the socket of a head; not measured (radii of the head).
  double least_socket = 0.8;

  // Largest radius, and distance of its points from the centre of the head:
  // BodyParts3D has a radius of 1.2 (radii of the head).
  double largest_socket = 1.6;

  // Where the shaft begins, beyond the wide end (of the length).
  double shaft_from = 0.3;

  // Where it ends (of the length).
  double shaft_to = 0.7;

  // Where the shaft of the lower piece of a femur begins, above the condyles
  // (of the height).
  double piece_from = 0.5;

  // The upper third of a femur's lower piece has at most so much of the
  // section of its lower third, or else it is upside down.
  double largest_section = 0.5;

  // Height of the lower end, which tells left and right: 35 mm for a head of
  // 23 mm (radii of the head).
  double end_height = 35.0 / 23;
};

}  // namespace musclewarp
