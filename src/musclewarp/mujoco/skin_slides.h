// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/mujoco/skin_weights.h"

namespace musclewarp {

// What bones cannot carry of a skin: bellies that bulge and slide. A slide
// moves with a bone of the skin and along a direction of it, by a polynomial of
// one coordinate, and takes each vertex along by a weight, which may be
// negative.
struct SkinSlide {
  int coordinate = -1;                                   // column of values
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  // at rest
  std::array<double, 5> coefficients = {0, 0, 0, 0, 0};  // mm by rad or m
  Eigen::VectorXd weights;  // #V, the largest is 1 or -1
};

struct SkinSlides {
  int bone = -1;  // of the skin, on which all slide; -1 if there are none
  std::vector<SkinSlide> slides;

  // How far the vertices are from those of the muscle in the frames then, mm.
  double mean_distance = 0, largest_distance = 0;
};

// Adds slides to a skin one by one, each time the one that explains most of
// what is left (singular vectors of its projection onto polynomials of each
// coordinate up to the fourth degree, or fewer if there are few frames), and
// improves all of them by turns, until the mean distance is at most
// `max_mean_distance`, there are kMostSkinSlides, or nothing is left that
// coordinates explain. `frames` and `motions` are those of FitSkin(); `values`,
// #frames x #C, has the coordinates in the frames, rad or m. All slides are on
// the bone on which fewest suffice. Preconditions (CHECKed): as many frames,
// motions and rows of values, and vertices as the skin has.
SkinSlides FitSlides(const SkinWeights& skin,
                     const std::vector<Points>& frames,
                     const std::vector<std::vector<Eigen::Matrix4d>>& motions,
                     const Eigen::MatrixXd& values,
                     double max_mean_distance);

constexpr int kMostSkinSlides = 12;

}  // namespace musclewarp
