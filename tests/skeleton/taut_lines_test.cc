// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/skeleton/taut_lines.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "musclewarp/mesh/transformed.h"
#include "musclewarp/skeleton/polyline.h"

namespace musclewarp {
namespace {

constexpr double kPi = 3.14159265358979323846;

// The steps of the solver end below 1e-10 mm.
constexpr double kSolved = 1e-8;

Eigen::Matrix4d Turn(const Eigen::Vector3d& center,
                     const Eigen::Vector3d& axis,
                     double angle) {
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  motion.topRightCorner<3, 1>() =
      center - motion.topLeftCorner<3, 3>() * center;
  return motion;
}

LineSupports NoSupports(Eigen::Index count) {
  LineSupports supports;
  supports.bends = supports.outward = Points::Zero(count, 3);
  supports.loads = supports.stiffness = supports.plane_stiffness =
      supports.hold = Eigen::VectorXd::Zero(count);
  return supports;
}

// Loads the bends of a line with what holds it at rest. The push doubles over
// `yield` mm; if that is 0, supports are hard.
void SupportBends(double yield, ActionLine* line) {
  for (Eigen::Index i = 1; i + 1 < line->rest.rows(); ++i) {
    const Eigen::RowVector3d bend =
        (line->rest.row(i + 1) - line->rest.row(i)).normalized() -
        (line->rest.row(i) - line->rest.row(i - 1)).normalized();
    const double load = bend.norm();
    if (load < 1e-9) continue;
    line->supports->bends.row(i) = bend / load;
    line->supports->loads[i] = load;
    line->supports->stiffness[i] = yield > 0 ? load / yield : 10;
  }
}

// A line in space with all kinds of supports. The first half of its points is
// on one body, the rest on another.
ActionLine WindingLine(double beside = 0) {
  constexpr int kCount = 16;
  ActionLine line;
  line.name = "line";
  line.rest.resize(kCount, 3);
  for (int i = 0; i < kCount; ++i) {
    const double t = i / (kCount - 1.0);
    line.rest.row(i) << 160 * t, 30 * std::sin(2.5 * t) + beside,
        12 * std::cos(5 * t) + beside * t;
    line.bodies.push_back(i < kCount / 2 ? "upper" : "lower");
  }
  line.slides = true;
  line.supports = NoSupports(kCount);
  SupportBends(5, &line);
  for (int i = 0; i < kCount; ++i) {
    line.supports->outward.row(i) =
        Eigen::RowVector3d(0.1, -1, 0.2 * i).normalized();
    line.supports->plane_stiffness[i] = i % 3 == 0 ? 10 : 2;
    line.supports->hold[i] = i < 3 ? 0.4 : 0;
  }
  return line;
}

// Two such lines side by side, tied to each other.
std::vector<ActionLine> TiedLines() {
  std::vector<ActionLine> lines = {WindingLine(), WindingLine(9)};
  lines[0].supports->ties = {
      {1, Eigen::VectorXd::Constant(lines[0].rest.rows(), 0.03)}};
  return lines;
}

std::vector<PointMotions> MotionsOf(const std::vector<ActionLine>& lines,
                                    const Eigen::Matrix4d& upper,
                                    const Eigen::Matrix4d& lower) {
  std::vector<PointMotions> motions;
  for (const ActionLine& line : lines) {
    motions.emplace_back();
    for (const std::string& body : line.bodies) {
      motions.back().push_back(body == "upper" ? upper : lower);
    }
  }
  return motions;
}

// A joint between the two bodies, and the whole turned a little.
std::vector<PointMotions> Bent(const std::vector<ActionLine>& lines,
                               double angle) {
  const Eigen::Matrix4d all = Turn({3, -20, 7}, {1, 2, -0.5}, 0.3);
  return MotionsOf(lines, all, all * Turn({80, -15, 0}, {0.1, 0.2, 1}, angle));
}

double Difference(const std::vector<Points>& a, const std::vector<Points>& b) {
  double largest = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, (a[i] - b[i]).cwiseAbs().maxCoeff());
  }
  return largest;
}

Points Mirrored(Points points) {
  points.col(1) *= -1;
  return points;
}

Eigen::Matrix4d Mirrored(const Eigen::Matrix4d& motion) {
  const Eigen::DiagonalMatrix<double, 4> mirror(1, -1, 1, 1);
  return mirror * motion * mirror;
}

TEST(TautLines, RestBodiesGiveTheLinesAtRestExactly) {
  const std::vector<ActionLine> lines = TiedLines();
  const Eigen::Matrix4d rest = Eigen::Matrix4d::Identity();
  const auto points = TautPoints(lines, MotionsOf(lines, rest, rest));
  EXPECT_EQ(Difference(points, {lines[0].rest, lines[1].rest}), 0);
}

TEST(TautLines, MoveWithAllBodies) {
  const std::vector<ActionLine> lines = TiedLines();
  auto motions = Bent(lines, 0.8);
  const auto points = TautPoints(lines, motions);
  const Eigen::Matrix4d motion = Turn({100, 50, -30}, {-1, 0.4, 2}, 2.2);
  std::vector<Points> expected;
  for (const Points& line : points) {
    expected.push_back(Transformed(line, motion));
  }
  for (auto& line : motions) {
    for (auto& of_point : line) of_point = motion * of_point;
  }
  EXPECT_LT(Difference(TautPoints(lines, motions), expected), kSolved);
}

TEST(TautLines, OfAMirroredBodyAreMirrored) {
  std::vector<ActionLine> lines = TiedLines();
  auto motions = Bent(lines, 0.8);
  std::vector<Points> expected = TautPoints(lines, motions);
  for (Points& line : expected) line = Mirrored(line);
  for (ActionLine& line : lines) {
    line.rest = Mirrored(line.rest);
    line.supports->bends = Mirrored(line.supports->bends);
    line.supports->outward = Mirrored(line.supports->outward);
  }
  for (auto& line : motions) {
    for (auto& motion : line) motion = Mirrored(motion);
  }
  EXPECT_LT(Difference(TautPoints(lines, motions), expected), kSolved);
}

TEST(TautLines, ScaleWithTheBody) {
  constexpr double kFactor = 0.05;
  std::vector<ActionLine> lines = TiedLines();
  auto motions = Bent(lines, 0.8);
  std::vector<Points> expected = TautPoints(lines, motions);
  for (Points& line : expected) line *= kFactor;
  for (ActionLine& line : lines) {
    line.rest *= kFactor;
    ScaleLengths(kFactor, &*line.supports);
  }
  for (auto& line : motions) {
    for (auto& motion : line) motion.topRightCorner<3, 1>() *= kFactor;
  }
  EXPECT_LT(Difference(TautPoints(lines, motions), expected), kSolved);
}

// The energy is convex: whichever supports bear at the start, the same do at
// the end. The start of the solver are the points moved with their bodies, so
// that another start is another rest pose with the same supports.
TEST(TautLines, AreTheShortestOfAllWaysNearby) {
  const std::vector<ActionLine> lines = {WindingLine()};
  const auto motions = Bent(lines, 1.1);
  const Points taut = TautPoints(lines, motions)[0];
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  const double least = TautEnergy(lines, motions, {taut});
  for (int round = 0; round < 200; ++round) {
    Points other = taut;
    for (Eigen::Index i = 1; i + 1 < other.rows(); ++i) {
      for (int c = 0; c < 3; ++c) {
        other(i, c) += std::pow(10, -3 + round % 5) * anywhere(random);
      }
    }
    EXPECT_GT(TautEnergy(lines, motions, {other}), least);
  }
}

TEST(TautLines, RatesAreDifferences) {
  const std::vector<ActionLine> lines = TiedLines();
  constexpr double kStep = 1e-5;
  const Eigen::Matrix4d all = Turn({3, -20, 7}, {1, 2, -0.5}, 0.3);
  const Eigen::Vector3d axis = Eigen::Vector3d(0.1, 0.2, 1).normalized();
  // The velocity of a point of the moving body: w x (p - c), in the pose.
  const Eigen::Vector3d turning = all.topLeftCorner<3, 3>() * axis;
  const Eigen::Vector3d center =
      (all * Eigen::Vector4d(80, -15, 0, 1)).head<3>();
  Eigen::Matrix4d rate = Eigen::Matrix4d::Zero();
  rate.topLeftCorner<3, 3>() << 0, -turning[2], turning[1], turning[2], 0,
      -turning[0], -turning[1], turning[0], 0;
  rate.topRightCorner<3, 1>() = -rate.topLeftCorner<3, 3>() * center;
  for (const double angle : {-0.6, 0.2, 0.9}) {
    const auto motions = Bent(lines, angle);
    const auto points = TautPoints(lines, motions);
    const auto rates =
        TautRates(lines,
                  motions,
                  points,
                  MotionsOf(lines, Eigen::Matrix4d::Zero(), rate));
    const auto before = TautPoints(lines, Bent(lines, angle - kStep));
    const auto after = TautPoints(lines, Bent(lines, angle + kStep));
    for (size_t i = 0; i < lines.size(); ++i) {
      // The second derivative is below 1e3 mm, and may jump where a support
      // begins to bear; the solver adds 1e-10 / kStep.
      EXPECT_LT(((after[i] - before[i]) / (2 * kStep) - rates[i])
                    .cwiseAbs()
                    .maxCoeff(),
                1e3 * kStep)
          << angle;
    }
  }
}

TEST(TautLines, AreStraightWithoutSupports) {
  ActionLine line = WindingLine();
  line.supports = NoSupports(line.rest.rows());
  const Points taut = TautPoints({line}, Bent({line}, 0.9))[0];
  EXPECT_LT(SharpestTurn(taut), 1e-9);
  EXPECT_LT(PolylineLength(taut), PolylineLength(line.rest));
}

TEST(TautLines, StretchIsEqualAlongThem) {
  ActionLine line = WindingLine();
  line.supports = NoSupports(line.rest.rows());
  const Points taut = TautPoints({line}, Bent({line}, 0.9))[0];
  const double stretch = PolylineLength(taut) / PolylineLength(line.rest);
  for (Eigen::Index i = 1; i < taut.rows(); ++i) {
    EXPECT_NEAR((taut.row(i) - taut.row(i - 1)).norm(),
                stretch * (line.rest.row(i) - line.rest.row(i - 1)).norm(),
                kSolved);
  }
}

// A line over a quarter of a disc, with straight parts before and beyond. Where
// the joint in the centre of the disc opens, the line stays on the part of the
// disc that presses it and leaves it along a tangent, so that its moment arm is
// the radius.
TEST(TautLines, OverADiscHaveTheArmOfItsRadius) {
  constexpr double kRadius = 30, kStraight = 60, kSpacing = 3;
  const double arc = kRadius * kPi / 2;
  const int count =
      static_cast<int>(std::lround((arc + 2 * kStraight) / kSpacing)) + 1;
  ActionLine line;
  line.name = "disc";
  line.rest.resize(count, 3);
  for (int i = 0; i < count; ++i) {
    const double along = (arc + 2 * kStraight) * i / (count - 1.0) - kStraight;
    const double on_disc = std::min(std::max(along, 0.0), arc);
    const double angle = kPi - on_disc / kRadius;
    line.rest.row(i) << kRadius * std::cos(angle) + std::max(along - arc, 0.0),
        kRadius * std::sin(angle) + std::min(along, 0.0), 0;
    line.bodies.push_back(along <= arc ? "upper" : "lower");
  }
  line.supports = NoSupports(count);
  SupportBends(0, &line);
  const auto length = [&](double angle) {
    return PolylineLength(
        TautPoints({line},
                   MotionsOf({line},
                             Eigen::Matrix4d::Identity(),
                             Turn({0, 0, 0}, {0, 0, 1}, angle)))[0]);
  };
  constexpr double kStep = 1e-4;
  for (const double angle : {0.02, 0.1, 0.2, 0.3}) {
    const double arm =
        -(length(angle + kStep) - length(angle - kStep)) / (2 * kStep);
    // The line slides by up to R angle / 2 along planes that do not bend with
    // the disc: at most 1.5 % of the radius at the largest angle, and its
    // supports of 10 / mm give way by hundredths of a mm.
    EXPECT_NEAR(arm, kRadius, 0.06 * kRadius) << angle;
  }
}

// A bend that something holds down lifts by 5 mm when its push doubles.
TEST(TautLines, ARetinaculumYieldsByItsShare) {
  constexpr double kYield = 5;
  ActionLine line;
  line.rest.resize(3, 3);
  line.rest << -100, 20, 0, 0, 0, 0, 100, 20, 0;
  line.bodies = {"upper", "upper", "lower"};
  line.supports = NoSupports(3);
  SupportBends(kYield, &line);
  // Without the string the support would be pressed by its yield for each of
  // its loads: of two equilibria, the force is the load and twice the load.
  const double load = line.supports->loads[1];
  const double lift = 5;  // into the direction of the bend, y
  Eigen::Matrix4d up = Eigen::Matrix4d::Identity();
  // Both ends are raised until the middle is in balance `lift` above its place:
  // the force of the string is then to be twice the load.
  const double length = (line.rest.row(1) - line.rest.row(0)).norm();
  up(1, 3) = 2 * load * length / 2 + lift - 20;
  const auto points =
      TautPoints({line}, {{up, Eigen::Matrix4d::Identity(), up}});
  EXPECT_NEAR(points[0](1, 1), lift, kSolved);
}

}  // namespace
}  // namespace musclewarp
