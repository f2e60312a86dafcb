// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/skeleton/line_supports.h"

namespace musclewarp {

// A line of action of a muscle in the rest pose: the polyline along which the
// muscle pulls, and which the mesh of the muscle follows when it is deformed.
struct ActionLine {
  std::string name;

  // The points of the polyline, #P x 3, mm. There are at least two, and
  // neighbours are distinct.
  Points rest;

  // The name of the body to which each point is fixed, #P entries. Empty if the
  // bodies are not known.
  std::vector<std::string> bodies;

  // If true, only the ends are fixed to the muscle: it slides along the line
  // between them, and all of it is stretched by the same factor. The bodies of
  // the points between only guide the line. Needs `bodies`.
  bool slides = false;

  // The lengths at its beginning and its end along which it stands for a tendon
  // without a mesh (preparation/bare_tendons.h), mm.
  double bare_begin = 0;
  double bare_end = 0;

  // What holds the line where it is taut (taut_lines.h), for sliding lines.
  // Made in the preparation (fibres/found_supports.h); without a value the
  // points between the ends move with the bodies that guide them.
  std::optional<LineSupports> supports = {};
};

// A line of action in the pose to which a muscle is deformed.
struct LineTarget {
  // The same points as ActionLine::rest, #P x 3, mm.
  Points points;

  // The rotation target_from_rest of the body to which each point is fixed, #P
  // entries, without a value where the body is not known. The list may be
  // empty, which means that no body is known.
  std::vector<std::optional<Eigen::Matrix3d>> body_rotations;
};

}  // namespace musclewarp
