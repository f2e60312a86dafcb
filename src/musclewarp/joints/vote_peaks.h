// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A place at which many votes meet, as those for the centre of a sphere do.
struct VotePeak {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // mm
  int votes = 0;  // at most the radius of the search away
};

// Returns up to `most` places with the largest numbers of `votes` (#P x 3, mm)
// within `radius`, in descending order and at least one radius apart. Each
// place is moved to the mean of the votes around it.
std::vector<VotePeak> FindVotePeaks(const Points& votes,
                                    double radius,
                                    int most);

}  // namespace musclewarp
