// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/opensim/kinematics.h"
#include "musclewarp/opensim/model.h"

namespace musclewarp {

// A point that is fixed to a body of a model: a site of MuJoCo.
struct Site {
  int body = -1;                                    // of the model
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  // in its frame, mm
};

// A path of straight segments through sites, whose length and moment arms are
// to be those of a muscle.
struct SitePath {
  std::vector<Site> sites;  // from origin to insertion

  // How far it is from the muscle in the samples: on the mean, the median and
  // at most, mm, and mm per rad or m.
  double length_mean = 0, length_largest = 0;
  double arm_median = 0, arm_largest = 0;
};

// A posture in which a path is known.
struct SitePosture {
  CoordinateValues values;  // of the model, couplers applied
  Points line;              // the line as the muscle carries it, #P x 3, mm, in
                            // the ground
  double length = 0;        // mm
  Eigen::VectorXd arms;     // of the coordinates, mm per rad or m
};

// Fits a path through sites to lengths and moment arms about `coordinates`
// (indices into the model). Sites begin where the line is on the mean, each on
// the body of `bodies` against which its part of the line moves least, and are
// moved by least squares. There are as few as reach a median error of the arms
// of kGoodArm, or as many as fit best. Preconditions (CHECKed): there are
// postures and bodies.
SitePath FitSites(const Model& model,
                  const std::vector<int>& bodies,
                  const std::vector<int>& coordinates,
                  const std::vector<SitePosture>& postures);

constexpr double kGoodArm = 1;  // mm per rad or m

}  // namespace musclewarp
