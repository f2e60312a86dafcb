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

// The length over which a guide that slides has one direction, mm.
constexpr double kSegmentLength = 10;
// A short line has at least this many segments.
constexpr int kFewestSegments = 8;
// Lines follow each other if their ends are nearer than this at rest, mm: a
// rounding of files, not a distance.
constexpr double kSamePlace = 0.01;

// A part counts as tendon if its area is below the first of these shares of the
// largest area of the muscle, as belly above the second.
constexpr double kTendonArea = 0.075;
constexpr double kBellyArea = 0.225;
// GuidePath::half_borne of taut lines: a belly bears more of a smaller stretch,
// and less of a larger one, until all of the muscle is stretched alike. Fibres
// of the calf shorten by a third from 15 degrees of dorsiflexion to 30 of
// plantarflexion (Maganaris et al. 1998, doi
// 10.1111/j.1469-7793.1998.603be.x).
constexpr double kHalfBorneByTaut = 0.3;
// The same for a path along a tendon without a mesh, which is known to be
// tendon: it gives way only where a mesh is too short for the belly.
constexpr double kHalfBorneByBare = 1;
// The share of a path that has to be belly.
constexpr double kLeastBelly = 0.05;
// Rounds of a binomial filter over the areas of neighbouring segments.
constexpr int kSmoothingRounds = 2;

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

Eigen::VectorXd SegmentLengths(const Points& points) {
  const Eigen::Index count = points.rows() - 1;
  return (points.bottomRows(count) - points.topRows(count)).rowwise().norm();
}

Eigen::VectorXd Smoothed(const Eigen::VectorXd& values) {
  Eigen::VectorXd smooth = values;
  const Eigen::Index last = values.size() - 1;
  for (int round = 0; round < kSmoothingRounds; ++round) {
    const Eigen::VectorXd before = smooth;
    for (Eigen::Index i = 0; i <= last; ++i) {
      smooth[i] = (before[std::max<Eigen::Index>(0, i - 1)] + 2 * before[i] +
                   before[std::min(last, i + 1)]) /
                  4;
    }
  }
  return smooth;
}

// Sets the compliance of all paths from the points inside of the muscle: the
// area across a segment is the number of points nearest to it by its length.
// Lines may run together in another part, each with an equal share of it.
void FindCompliance(const InsidePoints& inside,
                    bool is_tendon,
                    Guides* guides) {
  std::vector<Eigen::VectorXd> areas;
  for (const ActionLine& line : guides->lines) {
    areas.push_back(Eigen::VectorXd::Zero(line.rest.rows() - 1));
  }
  for (Eigen::Index i = 0; i < inside.own.rows(); ++i) {
    const SegmentPoint nearest =
        NearestSegment(inside.own.row(i), guides->lines);
    ++areas[nearest.line][nearest.segment];
  }
  const double count = static_cast<double>(areas.size());
  for (size_t g = 0; g < areas.size(); ++g) {
    const std::vector<ActionLine> alone = {guides->lines[g]};
    const Eigen::ArrayXd along_own =
        is_tendon ? Eigen::ArrayXd((areas[g].array() > 0).cast<double>())
                  : Eigen::ArrayXd::Zero(areas[g].size());
    for (Eigen::Index i = 0; i < inside.beyond.rows(); ++i) {
      const SegmentPoint nearest = NearestSegment(inside.beyond.row(i), alone);
      areas[g][nearest.segment] += inside.weights[i] / count;
    }
    const Eigen::VectorXd lengths = SegmentLengths(guides->lines[g].rest);
    areas[g].array() /= lengths.array().max(kSamePlace);
    Eigen::VectorXd& compliance = guides->paths[g].compliance;
    compliance = Compliance(Smoothed(areas[g])).array() * (1 - along_own);
    // Something has to bear the stretch, if only the tendon itself.
    if (compliance.dot(lengths) < kLeastBelly * lengths.sum()) {
      compliance.setOnes();
    }
  }
}

// Returns true if a path stands for a tendon without a mesh somewhere.
bool IsBare(const GuidePath& path, const std::vector<ActionLine>& lines) {
  return std::any_of(path.lines.begin(), path.lines.end(), [&](int line) {
    return lines[line].bare_begin + lines[line].bare_end > 0;
  });
}

// Returns at which shares of its length a path has its points when its length
// is `length`, mm.
Eigen::VectorXd SharesAt(const GuidePath& path, double length) {
  if (path.compliance.minCoeff() == 1 || !(path.rest_length > 0) ||
      !(length > 0)) {
    return path.shares;
  }
  const Eigen::Index count = path.compliance.size();
  const Eigen::VectorXd at_rest =
      path.shares.tail(count) - path.shares.head(count);
  const double stretch = length / path.rest_length - 1;
  const double mean = at_rest.dot(path.compliance);
  // The tendon is stretched by what the belly does not bear for it.
  const double whole = stretch / (path.half_borne * mean);
  const double borne = 1 / (1 + whole * whole);
  const double shared = (1 - borne) * stretch;
  const double by_compliance = borne * stretch / mean;
  Eigen::VectorXd shares = path.shares;
  for (Eigen::Index i = 0; i < count; ++i) {
    shares[i + 1] =
        shares[i] + at_rest[i] *
                        (1 + by_compliance * path.compliance[i] + shared) /
                        (1 + stretch);
  }
  return shares.cwiseMin(1);
}

}  // namespace

std::string ToString(LineRule rule) {
  switch (rule) {
    case LineRule::kTendon:
      return "tendon";
    case LineRule::kSlide:
      return "slide";
    case LineRule::kFixed:
      return "fixed";
  }
  LOG(FATAL) << "no such rule";
}

Eigen::VectorXd Compliance(const Eigen::VectorXd& areas) {
  const double largest = areas.maxCoeff();
  if (!(largest > 0)) return Eigen::VectorXd::Ones(areas.size());
  Eigen::ArrayXd x =
      (areas.array() / largest - kTendonArea) / (kBellyArea - kTendonArea);
  x = x.max(0).min(1);
  return x.square() * (3 - 2 * x);
}

Guides GuidesOf(const std::vector<ActionLine>& lines,
                LineRule rule,
                const InsidePoints& inside) {
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
    path.rest_length = PolylineLength(points);
    path.compliance = Eigen::VectorXd::Ones(segments);
    path.places = PlacesAt(chain, lines, SharesAlong(points), path.shares);
    path.lines = std::move(chain);
    guides.lines.push_back(
        {lines[path.lines[0]].name, PointsAtShares(points, path.shares), {}});
    guides.paths.push_back(std::move(path));
  }
  if (rule == LineRule::kTendon) {
    const bool is_taut =
        std::any_of(lines.begin(), lines.end(), [](const ActionLine& line) {
          return line.supports.has_value();
        });
    FindCompliance(inside, is_taut && inside.is_tendon, &guides);
    if (is_taut) {
      for (GuidePath& path : guides.paths) {
        path.half_borne =
            IsBare(path, lines) ? kHalfBorneByBare : kHalfBorneByTaut;
      }
    }
  }
  return guides;
}

std::vector<LineTarget> GuideTargets(const Guides& guides,
                                     const std::vector<LineTarget>& lines) {
  if (guides.rule == LineRule::kFixed) return lines;
  std::vector<LineTarget> targets;
  for (const GuidePath& path : guides.paths) {
    LineTarget target;
    const Points points = PathPoints(path.lines, lines);
    target.points =
        PointsAtShares(points, SharesAt(path, PolylineLength(points)));
    for (const SegmentPoint& place : path.places) {
      target.body_rotations.push_back(RotationAt(lines[place.line], place));
    }
    targets.push_back(std::move(target));
  }
  return targets;
}

}  // namespace musclewarp
