// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/guides.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

ActionLine Line(const std::string& name,
                const std::vector<Eigen::RowVector3d>& points,
                const std::string& body) {
  ActionLine line;
  line.name = name;
  line.rest.resize(points.size(), 3);
  for (size_t i = 0; i < points.size(); ++i) line.rest.row(i) = points[i];
  line.bodies.assign(points.size(), body);
  return line;
}

// A path over a corner, with segments of 60 and 40 mm.
ActionLine CornerLine() {
  return Line("corner", {{0, 0, 0}, {60, 0, 0}, {60, 40, 0}}, "pelvis");
}

LineTarget AtRest(const ActionLine& line) { return {line.rest, {}}; }

double Distance(const Points& a, const Points& b) {
  return (a - b).rowwise().norm().maxCoeff();
}

}  // namespace

TEST(Guides, FixedOnesAreTheLines) {
  const Guides guides = GuidesOf({CornerLine()}, LineRule::kFixed, {});
  ASSERT_EQ(guides.lines.size(), 1u);
  EXPECT_EQ(guides.lines[0].rest, CornerLine().rest);
  LineTarget target = AtRest(CornerLine());
  target.points *= 2;
  EXPECT_EQ(GuideTargets(guides, {target})[0].points, target.points);
}

TEST(Guides, AtRestAndMovedRigidlyTheyAreThoseAtRest) {
  const Guides guides = GuidesOf({CornerLine()}, LineRule::kSlide, {});
  EXPECT_EQ(GuideTargets(guides, {AtRest(CornerLine())})[0].points,
            guides.lines[0].rest);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, 2, 3).normalized())
          .toRotationMatrix();
  LineTarget moved;
  moved.points = CornerLine().rest * turn.transpose();
  moved.body_rotations.assign(3, turn);
  const LineTarget guide = GuideTargets(guides, {moved})[0];
  EXPECT_LT(Distance(guide.points, guides.lines[0].rest * turn.transpose()),
            1e-12);
  for (const auto& rotation : guide.body_rotations) {
    EXPECT_LT((*rotation - turn).norm(), 1e-14);
  }
}

// If one segment of the path gets longer, all of the muscle does, by the same
// factor.
TEST(Guides, SlideSoThatAllIsStretchedAlike) {
  const ActionLine straight =
      Line("straight", {{0, 0, 0}, {30, 0, 0}, {100, 0, 0}}, "pelvis");
  const Guides guides = GuidesOf({straight}, LineRule::kSlide, {});
  LineTarget longer = AtRest(straight);
  longer.points(1, 0) = 80;
  longer.points(2, 0) = 150;
  EXPECT_LT(Distance(GuideTargets(guides, {longer})[0].points,
                     1.5 * guides.lines[0].rest),
            1e-12);
}

TEST(Guides, LinesThatFollowEachOtherAreOnePath) {
  const ActionLine upper = Line("upper", {{-50, 0, 0}, {0, 0, 0}}, "pelvis");
  for (const bool is_lower_first : {false, true}) {
    const std::vector<ActionLine> lines =
        is_lower_first ? std::vector<ActionLine>{CornerLine(), upper}
                       : std::vector<ActionLine>{upper, CornerLine()};
    const Guides guides = GuidesOf(lines, LineRule::kSlide, {});
    ASSERT_EQ(guides.lines.size(), 1u);
    const Points& rest = guides.lines[0].rest;
    EXPECT_EQ(rest.row(0), upper.rest.row(0));
    EXPECT_EQ(rest.row(rest.rows() - 1), CornerLine().rest.row(2));
    // The lower line gets longer; half of the path is the upper one's.
    std::vector<LineTarget> targets;
    for (const ActionLine& line : lines) targets.push_back(AtRest(line));
    targets[is_lower_first ? 0 : 1].points.row(2) << 60, 190, 0;
    const Points moved = GuideTargets(guides, targets)[0].points;
    EXPECT_NEAR(moved(1, 0) - moved(0, 0), 2 * (rest(1, 0) - rest(0, 0)), 1e-9);
  }
}

// The factors by which the segments of a straight muscle are stretched that has
// a belly of `belly` mm and a tendon, 100 mm together, if all of it is by
// `stretch`.
Eigen::VectorXd StretchesOfSegments(double belly,
                                    double stretch,
                                    bool is_taut = false,
                                    bool is_bare = false) {
  ActionLine line = Line("line", {{0, 0, 0}, {100, 0, 0}}, "pelvis");
  if (is_taut) line.supports.emplace();
  if (is_bare) line.bare_end = 100 - belly;
  // Ten points in a millimetre of the belly, one in two of the tendon.
  std::vector<double> places;
  for (double x = 0.05; x < belly; x += 0.1) places.push_back(x);
  for (double x = belly + 1; x < 100; x += 2) places.push_back(x);
  Points inside = Points::Zero(places.size(), 3);
  for (size_t i = 0; i < places.size(); ++i) inside(i, 0) = places[i];
  const Guides guides = GuidesOf({line}, LineRule::kTendon, {inside, {}, {}});
  const Points& rest = guides.lines[0].rest;
  const Points moved =
      GuideTargets(guides, {{stretch * line.rest, {}}})[0].points;
  EXPECT_EQ(moved.row(0), rest.row(0));
  EXPECT_NEAR(moved(10, 0), 100 * stretch, 1e-12);
  return ((moved.bottomRows(10) - moved.topRows(10)).col(0).array() /
          (rest.bottomRows(10) - rest.topRows(10)).col(0).array());
}

// Of a stretch of the whole by 2 % the tendon takes less than a tenth.
TEST(Guides, TendonsKeepTheirLength) {
  for (const double stretch : {0.98, 1.0, 1.02}) {
    const Eigen::VectorXd factors = StretchesOfSegments(70, stretch);
    EXPECT_NEAR(factors[9], 1, 0.1 * std::abs(stretch - 1) + 1e-12);
    EXPECT_NEAR(factors[0], factors[4], 1e-12);
    // The seventh segment lies between belly and tendon.
    EXPECT_NEAR(factors[0] - 1, (stretch - 1) / 0.7, 0.005);
  }
}

// Along taut lines the tendon keeps its length up to larger stretches.
TEST(Guides, TautTendonsKeepTheirLengthLonger) {
  const double taut = StretchesOfSegments(50, 0.9, true)[9];
  EXPECT_LT(std::abs(taut - 1), 0.04);
  EXPECT_GT(std::abs(StretchesOfSegments(50, 0.9)[9] - 1), 0.07);
}

// A line along a tendon without a mesh is known to be tendon there.
TEST(Guides, TendonsWithoutAMeshKeepTheirLengthLongest) {
  const double taut = StretchesOfSegments(50, 0.9, true)[9];
  const double bare = StretchesOfSegments(50, 0.9, true, true)[9];
  EXPECT_LT(std::abs(bare - 1), 0.005);
  EXPECT_LT(std::abs(bare - 1), std::abs(taut - 1) / 4);
}

// What runs along a tendon with a mesh of its own keeps its length, also where
// a belly lies beside it; where nothing else bears the stretch, all of it does.
TEST(Guides, TendonsWithAMeshKeepTheirLength) {
  ActionLine line = Line("line", {{0, 0, 0}, {100, 0, 0}}, "pelvis");
  line.supports.emplace();
  InsidePoints inside;
  inside.is_tendon = true;
  inside.own = Points::Zero(50, 3);
  inside.own.col(0).setLinSpaced(0, 49);
  inside.beyond = Points::Zero(1000, 3);
  inside.beyond.col(0).setLinSpaced(0, 100);
  inside.weights = Eigen::VectorXd::Ones(1000);
  const auto moved = [&](const InsidePoints& points) {
    const Guides guides = GuidesOf({line}, LineRule::kTendon, points);
    return GuideTargets(guides, {{1.02 * line.rest, {}}})[0].points;
  };
  EXPECT_NEAR(moved(inside)(5, 0), 50, 0.05);
  inside.beyond.resize(0, 3);
  inside.weights.resize(0);
  inside.own.col(0).setLinSpaced(0, 100);
  EXPECT_NEAR(moved(inside)(5, 0), 51, 1e-9);
}

// The tendon of a short belly gives earlier, so that no belly is stretched by a
// tenth of its length more than the whole; at last all is stretched alike.
TEST(Guides, AShortBellyIsSpared) {
  for (const double sign : {-1.0, 1.0}) {
    for (double stretch = 0.01; stretch < 0.6; stretch += 0.01) {
      const Eigen::VectorXd factors =
          StretchesOfSegments(30, 1 + sign * stretch);
      EXPECT_LT(std::abs(factors[0] - 1), stretch + 0.1);
      EXPECT_LE(std::abs(factors[9] - 1), stretch);
    }
    const Eigen::VectorXd much = StretchesOfSegments(30, 1 + sign * 0.9);
    EXPECT_LT((much.array() - 1 - sign * 0.9).abs().maxCoeff(), 0.02);
  }
}

// Moment arms are derivatives: what a tendon takes has no kinks.
TEST(Guides, TendonsGiveSmoothly) {
  constexpr double kStep = 0.005;
  for (double stretch = 0.7; stretch < 1.3; stretch += kStep) {
    const Eigen::VectorXd bend = StretchesOfSegments(60, stretch - kStep) -
                                 2 * StretchesOfSegments(60, stretch) +
                                 StretchesOfSegments(60, stretch + kStep);
    EXPECT_LT(bend.cwiseAbs().maxCoeff(), 30 * kStep * kStep);
  }
}

TEST(Compliance, IsThatOfThinParts) {
  Eigen::VectorXd areas(4);
  areas << 100, 30, 15, 1;
  const Eigen::VectorXd compliance = Compliance(areas);
  EXPECT_EQ(compliance[0], 1);
  EXPECT_EQ(compliance[1], 1);
  EXPECT_NEAR(compliance[2], 0.5, 1e-14);
  EXPECT_EQ(compliance[3], 0);
  EXPECT_EQ(Compliance(1000 * areas), compliance);
  EXPECT_EQ(Compliance(Eigen::VectorXd::Zero(10)).minCoeff(), 1);
}

// Lines that part or come together are no path; a ring begins with its first
// line.
TEST(Guides, FansAreNoPath) {
  const ActionLine other = Line("other", {{60, 40, 0}, {90, 90, 0}}, "pelvis");
  ActionLine fork = other;
  fork.rest(1, 0) = 30;
  EXPECT_EQ(
      GuidesOf({CornerLine(), other, fork}, LineRule::kSlide, {}).lines.size(),
      3u);
  ActionLine from_elsewhere = CornerLine();
  from_elsewhere.rest(0, 2) = 50;
  EXPECT_EQ(
      GuidesOf({CornerLine(), from_elsewhere, other}, LineRule::kSlide, {})
          .lines.size(),
      3u);
  ActionLine on_femur = other;
  on_femur.bodies = {"femur", "femur"};
  EXPECT_EQ(
      GuidesOf({CornerLine(), on_femur}, LineRule::kSlide, {}).lines.size(),
      2u);
  const ActionLine back = Line("back", {{60, 40, 0}, {0, 0, 0}}, "pelvis");
  EXPECT_EQ(GuidesOf({CornerLine(), back}, LineRule::kSlide, {}).lines.size(),
            1u);
}

// Where the corner of a path moves along a muscle, its directions change
// gradually: a small slide makes a small change.
TEST(Guides, DirectionsAreContinuous) {
  const Guides guides = GuidesOf({CornerLine()}, LineRule::kSlide, {});
  const auto segment_at = [&](double slide, Eigen::Index segment) {
    LineTarget target = AtRest(CornerLine());
    target.points(0, 0) -= slide;
    const Points points = GuideTargets(guides, {target})[0].points;
    return Eigen::RowVector3d(
        (points.row(segment + 1) - points.row(segment)).normalized());
  };
  constexpr double kSmall = 1e-4;
  for (double slide = 0; slide < 60; slide += 1.7) {
    for (Eigen::Index s = 0; s + 1 < guides.lines[0].rest.rows(); ++s) {
      EXPECT_LT((segment_at(slide + kSmall, s) - segment_at(slide, s)).norm(),
                1e-4);
    }
  }
}

}  // namespace musclewarp
