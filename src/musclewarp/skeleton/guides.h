// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/skeleton/action_line.h"
#include "musclewarp/skeleton/nearest_segment.h"

namespace musclewarp {

// How a muscle follows its lines of action where they get longer or shorter.
enum class LineRule {
  // It slides along them. Its thin parts, which are tendons, keep their length
  // as long as the belly need not be stretched much for that.
  kTendon,
  // It slides along them: each place keeps its share of the length, so that the
  // whole muscle is stretched evenly.
  kSlide,
  // Each place keeps its place in its segment, as in the paper (section 2.2):
  // all stretch is borne by the segments that change their length, which are
  // those that cross a joint.
  kFixed,
};

std::string ToString(LineRule rule);

// What a guide that slides is made of: lines of action that follow each other.
struct GuidePath {
  std::vector<int> lines;            // of the muscle, in order
  Eigen::VectorXd shares;            // #Q of the length, from 0 to 1
  std::vector<SegmentPoint> places;  // #Q on the lines, at rest
  double rest_length = 0;            // mm

  // How much of the stretch of the path each segment bears, #Q - 1, from 0
  // to 1.
  Eigen::VectorXd compliance;

  // When the belly would have to be stretched or shortened by this share of its
  // length so that the tendon keeps its own, it bears half of the tendon's
  // stretch.
  double half_borne = 0.1;
};

// The polylines that a muscle follows, made of its lines of action. A guide
// that slides has points at equal distances along a path: a line of action, or
// several that follow each other, each beginning where the one before ends. The
// segments between points are the directions of the muscle, so that these
// change gradually where the muscle slides round a corner of the path. A fixed
// guide is a line of action itself.
struct Guides {
  LineRule rule = LineRule::kFixed;

  // The guides at rest. They have names and points, and no bodies.
  std::vector<ActionLine> lines;

  // One for each guide that slides; none if they are fixed.
  std::vector<GuidePath> paths;
};

// Points spread evenly inside a muscle, and inside the other soft parts through
// which its lines go on; in mm, at rest.
struct InsidePoints {
  Points own;               // #I x 3
  Points beyond;            // #J x 3
  Eigen::VectorXd weights;  // #J: how many points of `own` each counts for

  // True for a tendon with a mesh of its own. Taut lines keep their lengths
  // along it, whatever lies beside it; the tendons on which a muscle ends have
  // no points in `beyond`, so that its lines keep theirs there, too.
  bool is_tendon = false;
};

// Makes the guides of a muscle with the given lines of action. From the points
// inside kTendon tells where the lines run through tendon; without any it is
// kSlide.
Guides GuidesOf(const std::vector<ActionLine>& lines,
                LineRule rule,
                const InsidePoints& inside);

// Returns the compliance of the segments of a path from the areas (#S) across
// the muscle there: 0 where the area is small against the largest, 1 where it
// is not. Without any area all is 1.
Eigen::VectorXd Compliance(const Eigen::VectorXd& areas);

// Returns where the guides are when the lines of action are at `lines`. The
// rotation of a point of a guide that slides lies between those of the bodies
// at the ends of the segment in which it lies at rest. At rest this gives the
// guides at rest, and a rigid motion of all lines moves the guides with them.
std::vector<LineTarget> GuideTargets(const Guides& guides,
                                     const std::vector<LineTarget>& lines);

}  // namespace musclewarp
