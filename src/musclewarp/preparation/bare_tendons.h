// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/anatomy/landmark_point.h"
#include "musclewarp/preparation/surroundings.h"
#include "musclewarp/scene/scene.h"
#include "musclewarp/skeleton/action_line.h"

namespace musclewarp {

// A tendon of which there is no mesh: the lines of a muscle go on along it from
// the end of the mesh to a bone.
struct BareTendon {
  bool is_at_origin = false;  // or at the insertion
  std::string body;           // on which it ends
  std::string bone;           // of the scene
  std::string landmark;       // of anatomy; empty for the nearest point
  double length = 0;          // mean of the lines at rest, mm
  LandmarkEvidence evidence = LandmarkEvidence::kFound;
};

// Lets the lines that were made for a muscle go on at the sides that they miss
// (MissedSides): to the landmark there that is nearest, or to the nearest point
// of the bones of the body, as the shortest way over the bones and past the
// pulleys of the muscle (TendonCourse). Lines are marked there
// (ActionLine::bare_begin, bare_end). `image` is as for AxesAt. Returns the
// tendons.
std::vector<BareTendon> AddBareTendons(const SceneMuscle& muscle,
                                       const Surroundings& surroundings,
                                       const Eigen::Matrix3d& image,
                                       std::vector<ActionLine>* lines);

// Returns a sentence for each bare tendon of a muscle. Lengths are in units of
// `body_size` mm (Scene::body_size).
std::vector<std::string> BareTendonWarnings(
    const std::string& muscle,
    const std::vector<BareTendon>& tendons,
    double body_size);

}  // namespace musclewarp
