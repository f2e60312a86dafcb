// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The numbers of fits, of heads and of shafts (joint_search.h).

#include "musclewarp/base/described.h"

namespace musclewarp {

// Votes for centres, and fits that start where they meet.
struct FitNumbers {
  double vote_tolerance = 0.15;
  double radius_step = 1;
  int peaks_of_sphere = 3;
  int peaks_of_circle = 5;
  double loss_scale = 0.4;
  double pass_scale = 1;
  int fit_rounds = 6;
  int fewest_points = 30;
  double least_normal = 0.85;
  double sphere_reach = 1.5;
};

constexpr auto FieldsOf(Described<FitNumbers>) {
  using F = FitNumbers;
  return std::make_tuple(
      Field(&F::vote_tolerance, "vote_tolerance", "radii")
          .Text("votes so near to a centre count for it: those of normals "
                "within 9 degrees of the radii"),
      Field(&F::radius_step, "radius_step", "mm")
          .Text("between radii that are tried: half of what votes tolerate at "
                "the smallest head"),
      Field(&F::peaks_of_sphere, "peaks_of_sphere")
          .Text("places that start a sphere of each radius; not measured"),
      Field(&F::peaks_of_circle, "peaks_of_circle")
          .Text("places that start a circle of each radius; not measured"),
      Field(&F::loss_scale, "loss_scale", "mm")
          .Text("points farther from a shape count less: half of the spread of "
                "a head on which a fit is good"),
      Field(&F::pass_scale, "pass_scale", "mm")
          .Text("normals that pass an axis by more count less; not measured"),
      Field(&F::fit_rounds, "fit_rounds")
          .Text("how often the points near a shape are chosen anew, within a "
                "tolerance that narrows; not measured"),
      Field(&F::fewest_points, "fewest_points")
          .Text("a fit needs so many: 43 mm2 of surface; not measured"),
      Field(&F::least_normal, "least_normal", "cosine")
          .Text("of a normal and the radius at its point: within 32 degrees"),
      Field(&F::sphere_reach, "sphere_reach", "mm")
          .Text("points so near to a sphere or dome belong to it in the last "
                "rounds; not measured"));
}

// The head of a femur or humerus, and the shaft of a femur.
struct HeadSearch {
  double least_head_radius = 14;
  double largest_head_radius = 32;
  double usual_head_radius = 23;
  double coarse_normals = 5;
  double uncertain_coverage = 50;
  double least_socket = 0.8;
  double largest_socket = 1.6;
  double shaft_from = 0.3;
  double shaft_to = 0.7;
  double piece_from = 0.5;
  double largest_section = 0.5;
  double end_height = 35.0 / 23;
};

constexpr auto FieldsOf(Described<HeadSearch>) {
  using F = HeadSearch;
  return std::make_tuple(
      Field(&F::least_head_radius, "least_head_radius", "mm")
          .Text("radius of the smallest head that is looked for; those of all "
                "three persons have 23 mm"),
      Field(&F::largest_head_radius, "largest_head_radius", "mm")
          .Text("radius of the largest one; not measured"),
      Field(&F::usual_head_radius, "usual_head_radius", "mm")
          .Text("of a head that is not known: that of LHDL and BodyParts3D"),
      Field(&F::coarse_normals, "coarse_normals", "mm")
          .Text(
              "normals of uncertain heads are averaged over this: the head "
              "of 3 mm voxels then covers 55 % in place of 25 %, and the next "
              "best place no more than before"),
      Field(&F::uncertain_coverage, "uncertain_coverage", "%")
          .Text("a head that covers less is uncertain: whole ones of all three "
                "persons cover 58 to 64 %"),
      Field(&F::least_socket, "least_socket", "radii")
          .Text("least radius of the socket of a head; not measured"),
      Field(&F::largest_socket, "largest_socket", "radii")
          .Text("largest radius, and distance of its points from the centre of "
                "the head: BodyParts3D has a radius of 1.2"),
      Field(&F::shaft_from, "shaft_from", "of the length")
          .Text("where the shaft begins, beyond the wide end"),
      Field(&F::shaft_to, "shaft_to", "of the length").Text("where it ends"),
      Field(&F::piece_from, "piece_from", "of the height")
          .Text("where the shaft of the lower piece of a femur begins, above "
                "the condyles"),
      Field(&F::largest_section, "largest_section")
          .Text("the upper third of a femur's lower piece has at most so much "
                "of the section of its lower third, or else it is upside down"),
      Field(&F::end_height, "end_height", "radii")
          .Text("height of the lower end, which tells left and right: 35 mm "
                "for a head of 23 mm"));
}

}  // namespace musclewarp
