// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/half_space_projection.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

constexpr double kAnywhere = 1e6;  // mm

// Points count as inside up to 1e-9 mm. Where planes are nearly parallel, the
// point at which they meet is farther off, mm.
constexpr double kInside = 1e-7;

bool Project(const std::vector<HalfSpace>& spaces,
             double farthest,
             RowVector3d* point) {
  return ProjectIntoHalfSpaces(
      spaces.data(), static_cast<int>(spaces.size()), farthest, point);
}

bool IsIn(const std::vector<HalfSpace>& spaces, const RowVector3d& point) {
  for (const HalfSpace& space : spaces) {
    if (space.normal.dot(point) < space.level - kInside) return false;
  }
  return true;
}

// The distance to the nearest point in all, by every choice of at most three
// borders that may hold it.
double LeastDistance(const std::vector<HalfSpace>& spaces,
                     const RowVector3d& point) {
  double least = INFINITY;
  const int count = static_cast<int>(spaces.size());
  const auto offer = [&](const std::vector<int>& chosen) {
    const Eigen::Index k = static_cast<Eigen::Index>(chosen.size());
    Eigen::MatrixXd normals(k, 3);
    Eigen::VectorXd missing(k);
    for (Eigen::Index i = 0; i < k; ++i) {
      const HalfSpace& space = spaces[chosen[i]];
      normals.row(i) = space.normal;
      missing[i] = space.level - space.normal.dot(point);
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> gram(normals * normals.transpose());
    if (!gram.isInvertible()) return;
    const RowVector3d move = gram.solve(missing).transpose() * normals;
    if (IsIn(spaces, point + move)) least = std::min(least, move.norm());
  };
  if (IsIn(spaces, point)) return 0;
  for (int i = 0; i < count; ++i) {
    offer({i});
    for (int j = 0; j < i; ++j) {
      offer({i, j});
      for (int k = 0; k < j; ++k) offer({i, j, k});
    }
  }
  return least;
}

TEST(ProjectIntoHalfSpaces, FindsTheNearestPoint) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  int found = 0, missing = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<HalfSpace> spaces(trial % 14);
    for (HalfSpace& space : spaces) {
      space.normal = RowVector3d(normal(random), normal(random), normal(random))
                         .normalized();
      space.level = normal(random);
    }
    const RowVector3d point(normal(random), normal(random), normal(random));
    RowVector3d nearest = point;
    const double expected = LeastDistance(spaces, point);
    const bool is_found = Project(spaces, kAnywhere, &nearest);
    ASSERT_EQ(is_found, std::isfinite(expected)) << "trial " << trial;
    if (is_found) {
      ++found;
      EXPECT_TRUE(IsIn(spaces, nearest)) << "trial " << trial;
      EXPECT_NEAR((nearest - point).norm(), expected, kInside)
          << "trial " << trial;
    } else {
      ++missing;
      EXPECT_EQ(nearest, point) << "trial " << trial;
    }
  }
  EXPECT_GT(found, 500);
  EXPECT_GT(missing, 500);
}

// What simple projections take hundreds of turns for.
TEST(ProjectIntoHalfSpaces, ReachesTheEdgeOfANarrowWedge) {
  const double angle = 0.01;  // rad
  // Planes are reached up to 1e-9 mm, which is 1e-7 mm along the wedge.
  constexpr double kAlong = 1e-6;
  const std::vector<HalfSpace> spaces = {
      {RowVector3d(std::sin(angle), std::cos(angle), 0), 0},
      {RowVector3d(std::sin(angle), -std::cos(angle), 0), 0}};
  RowVector3d point(-3, 0.001, 5);
  ASSERT_TRUE(Project(spaces, kAnywhere, &point));
  EXPECT_LT((point - RowVector3d(0, 0, 5)).norm(), kAlong);
}

TEST(ProjectIntoHalfSpaces, GoesNoFartherThanAllowed) {
  const std::vector<HalfSpace> spaces = {{RowVector3d(1, 0, 0), 2}};
  RowVector3d point(0, 1, 0);
  EXPECT_FALSE(Project(spaces, 1.9, &point));
  EXPECT_EQ(point, RowVector3d(0, 1, 0));
  EXPECT_TRUE(Project(spaces, 2.1, &point));
  EXPECT_EQ(point, RowVector3d(2, 1, 0));
}

// The greatest distance of a point from the half-spaces that it is outside of.
double WorstViolation(const std::vector<HalfSpace>& spaces,
                      const RowVector3d& point) {
  double worst = 0;
  for (const HalfSpace& space : spaces) {
    worst = std::max(worst, space.level - space.normal.dot(point));
  }
  return worst;
}

// How much a millimetre of violation counts.
constexpr double kWeight = 10;

void Compromise(const std::vector<HalfSpace>& spaces, RowVector3d* point) {
  CompromiseBetweenHalfSpaces(
      spaces.data(), static_cast<int>(spaces.size()), kWeight, point);
}

// What CompromiseBetweenHalfSpaces makes least.
double Cost(const std::vector<HalfSpace>& spaces,
            const RowVector3d& from,
            const RowVector3d& to) {
  const double violation = kWeight * WorstViolation(spaces, to);
  return (to - from).squaredNorm() + violation * violation;
}

TEST(CompromiseBetweenHalfSpaces, SharesTheViolationWhateverTheOrder) {
  // Half a millimetre is missing, however often one side says so.
  std::vector<HalfSpace> spaces(9, {RowVector3d(1, 0, 0), 0.25});
  spaces.push_back({RowVector3d(-1, 0, 0), 0.25});
  for (int order = 0; order < 2; ++order) {
    RowVector3d point(0.25, 2, -1);
    Compromise(spaces, &point);
    EXPECT_NEAR(point[0], 0, kInside);
    EXPECT_EQ(point[1], 2);
    EXPECT_EQ(point[2], -1);
    std::reverse(spaces.begin(), spaces.end());
  }
}

TEST(CompromiseBetweenHalfSpaces, IsBetterThanThePlacesAround) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto draw = [&] {
    return RowVector3d(normal(random), normal(random), normal(random));
  };
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<HalfSpace> spaces(4 + trial % 20);
    for (HalfSpace& space : spaces) {
      space = {draw().normalized(), normal(random)};
    }
    const RowVector3d from = draw();
    RowVector3d point = from;
    Compromise(spaces, &point);
    const double cost = Cost(spaces, from, point);
    for (const double far : {1e-3, 0.1, 1.0}) {
      for (int other = 0; other < 20; ++other) {
        EXPECT_GE(Cost(spaces, from, point + far * draw()), cost - kInside)
            << "trial " << trial;
      }
    }
  }
}

// Of a point d before a plane, m^2 + w^2 (d - m)^2 is least for a move by
// m = d w^2 / (1 + w^2).
TEST(CompromiseBetweenHalfSpaces, GoesTheWayThatTheWeightAsksFor) {
  const std::vector<HalfSpace> spaces = {{RowVector3d(0.6, 0, 0.8), 3}};
  for (const double weight : {0.1, 1.0, 3.0, 100.0}) {
    RowVector3d point(0, 7, 0);
    CompromiseBetweenHalfSpaces(spaces.data(), 1, weight, &point);
    const double share = weight * weight / (1 + weight * weight);
    EXPECT_LT((point - RowVector3d(1.8 * share, 7, 2.4 * share)).norm(),
              kInside)
        << "weight " << weight;
  }
}

TEST(CompromiseBetweenHalfSpaces, LeavesAPointThatIsInAll) {
  const std::vector<HalfSpace> spaces = {{RowVector3d(1, 0, 0), 1},
                                         {RowVector3d(0, 1, 0), 2}};
  RowVector3d point(1.5, 2.5, 7);
  Compromise(spaces, &point);
  EXPECT_EQ(point, RowVector3d(1.5, 2.5, 7));
}

// Between two that have no point in common; a third one is not in the way.
TEST(ApproachHalfSpaces, EndsBetweenThoseWithoutACommonPoint) {
  const std::vector<HalfSpace> spaces = {{RowVector3d(1, 0, 0), 1},
                                         {RowVector3d(-1, 0, 0), 1},
                                         {RowVector3d(0, 1, 0), -4}};
  RowVector3d point(0.3, 2, 0);
  ApproachHalfSpaces(spaces.data(), 3, 10, &point);
  constexpr double kRounding = 1e-12;
  EXPECT_LE(std::abs(point[0]), 1 + kRounding);
  EXPECT_EQ(point[1], 2);
  EXPECT_EQ(point[2], 0);
}

TEST(ApproachHalfSpaces, ReachesACommonPoint) {
  const std::vector<HalfSpace> spaces = {{RowVector3d(1, 0, 0), 1},
                                         {RowVector3d(0, 1, 0), 2}};
  RowVector3d point(0, 0, 7);
  ApproachHalfSpaces(spaces.data(), 2, 3, &point);
  EXPECT_EQ(point, RowVector3d(1, 2, 7));
}

}  // namespace
}  // namespace musclewarp
