// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/guides.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "musclewarp/skeleton/polyline.h"
#include "musclewarp/skeleton/sampling.h"

namespace musclewarp {
namespace {

// The length over which a guide that slides has one direction, mm. Half and
// twice of it give the same shapes and moment arms of the LHDL hip.
constexpr double kSegmentLength = 10;
// A short line has at least this many segments.
constexpr int kFewestSegments = 8;
// Lines follow each other if their ends are nearer than this at rest, mm: a
// rounding of files, not a distance.
constexpr double kSamePlace = 0.01;

// Returns the line that begins where `line` ends, or -1 if there is none or
// more than one.
int LineAfter(const std::vector<ActionLine>& lines, size_t line) {
  const Points& rest = lines[line].rest;
  const auto body = [](const ActionLine& of, Eigen::Index point) {
    return of.bodies.empty() ? std::string() : of.bodies[point];
  };
  int after = -1;
  for (size_t other = 0; other < lines.size(); ++other) {
    if (other == line ||
        (lines[other].rest.row(0) - rest.row(rest.rows() - 1)).norm() >
            kSamePlace ||
        body(lines[other], 0) != body(lines[line], rest.rows() - 1)) {
      continue;
    }
    if (after >= 0) return -1;
    after = static_cast<int>(other);
  }
  return after;
}

// Returns the lines in paths: each line is in one of them.
std::vector<std::vector<int>> Paths(const std::vector<ActionLine>& lines) {
  const int count = static_cast<int>(lines.size());
  std::vector<int> after(count), num_before(count, 0);
  for (int i = 0; i < count; ++i) {
    after[i] = LineAfter(lines, i);
    if (after[i] >= 0) ++num_before[after[i]];
  }
  // Where several lines end at the beginning of one, each stays on its own.
  for (int& next : after) {
    if (next >= 0 && num_before[next] > 1) next = -1;
  }
  std::vector<char> follows(count, 0), is_taken(count, 0);
  for (const int next : after) {
    if (next >= 0) follows[next] = 1;
  }
  std::vector<std::vector<int>> paths;
  const auto add = [&](int first) {
    paths.emplace_back();
    for (int i = first; i >= 0 && !is_taken[i]; i = after[i]) {
      is_taken[i] = 1;
      paths.back().push_back(i);
    }
  };
  for (int i = 0; i < count; ++i) {
    if (!follows[i]) add(i);
  }
  for (int i = 0; i < count; ++i) {
    if (!is_taken[i]) add(i);  // a ring of lines
  }
  return paths;
}

// The points of the lines of a path, one line after the other.
Points PathPoints(const std::vector<int>& path,
                  const std::vector<LineTarget>& lines) {
  Eigen::Index count = 0;
  for (const int line : path) count += lines[line].points.rows();
  Points points(count, 3);
  Eigen::Index row = 0;
  for (const int line : path) {
    points.middleRows(row, lines[line].points.rows()) = lines[line].points;
    row += lines[line].points.rows();
  }
  return points;
}

// Returns the places (#S) on the lines of a path at shares of its length.
std::vector<SegmentPoint> PlacesAt(const std::vector<int>& path,
                                   const std::vector<ActionLine>& lines,
                                   const Eigen::VectorXd& along,
                                   const Eigen::VectorXd& shares) {
  std::vector<SegmentPoint> places;
  for (const double share : shares) {
    SegmentPoint place;
    Eigen::Index row = 0;  // of `along`
    for (const int line : path) {
      for (int s = 0; s + 1 < lines[line].rest.rows(); ++s) {
        const double begin = along[row + s];
        const double width = along[row + s + 1] - begin;
        if (place.line >= 0 && share < begin) break;
        const double t = width > 0 ? (share - begin) / width : 0;
        place = {line, s, std::clamp(t, 0.0, 1.0)};
      }
      row += lines[line].rest.rows();
    }
    places.push_back(place);
  }
  return places;
}

std::optional<Eigen::Matrix3d> RotationAt(const LineTarget& line,
                                          const SegmentPoint& place) {
  if (line.body_rotations.empty()) return std::nullopt;
  const auto& begin = line.body_rotations[place.segment];
  const auto& end = line.body_rotations[place.segment + 1];
  if (!begin || !end) return begin ? begin : end;
  return Eigen::Quaterniond(*begin)
      .slerp(place.t, Eigen::Quaterniond(*end))
      .toRotationMatrix();
}

}  // namespace

Guides GuidesOf(const std::vector<ActionLine>& lines, LineRule rule) {
  Guides guides;
  guides.rule = rule;
  if (rule == LineRule::kFixed) {
    for (const ActionLine& line : lines) {
      guides.lines.push_back({line.name, line.rest, {}});
    }
    return guides;
  }
  std::vector<LineTarget> at_rest;
  for (const ActionLine& line : lines) at_rest.push_back({line.rest, {}});
  for (std::vector<int>& chain : Paths(lines)) {
    const Points points = PathPoints(chain, at_rest);
    const int segments = std::max(
        kFewestSegments, NumPieces(PolylineLength(points), kSegmentLength));
    GuidePath path;
    path.shares = Eigen::VectorXd::LinSpaced(segments + 1, 0, 1);
    path.places = PlacesAt(chain, lines, SharesAlong(points), path.shares);
    path.lines = std::move(chain);
    guides.lines.push_back(
        {lines[path.lines[0]].name, PointsAtShares(points, path.shares), {}});
    guides.paths.push_back(std::move(path));
  }
  return guides;
}

std::vector<LineTarget> GuideTargets(const Guides& guides,
                                     const std::vector<LineTarget>& lines) {
  if (guides.rule == LineRule::kFixed) return lines;
  std::vector<LineTarget> targets;
  for (const GuidePath& path : guides.paths) {
    LineTarget target;
    target.points = PointsAtShares(PathPoints(path.lines, lines), path.shares);
    for (const SegmentPoint& place : path.places) {
      target.body_rotations.push_back(RotationAt(lines[place.line], place));
    }
    targets.push_back(std::move(target));
  }
  return targets;
}

}  // namespace musclewarp
