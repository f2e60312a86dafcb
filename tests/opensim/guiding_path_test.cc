// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/guiding_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "opensim/read_models.h"

namespace musclewarp {
namespace {

constexpr double kRangeEnd = -0.5;  // rad

std::string OnThigh(const std::string& name,
                    const std::string& location,
                    const std::string& range) {
  return Point4(name,
                "thigh",
                location,
                "ConditionalPathPoint",
                "<socket_coordinate>/jointset/knee_joint/q</socket_coordinate>"
                "<range>" +
                    range + "</range>");
}

// A path from the thigh to the shank with the given points between.
Model ModelWith(const std::string& between) {
  return ReadText(Model4(Joint4("PinJoint", "q"),
                         "",
                         Muscle("m",
                                Point4("p1", "thigh", "0.02 -0.1 0") + between +
                                    Point4("p3", "shank", "0.03 -0.1 0"))));
}

Model OnePointModel() {
  return ModelWith(OnThigh("p2", "0.06 -0.4 0", "-2 -0.5"));
}

Points PathAt(const Model& model, double q) {
  return GuidingPath(model, model.muscles[0], BodyFrames(model, {q}), {q});
}

double LengthOf(const Points& path) {
  double length = 0;
  for (Eigen::Index i = 1; i < path.rows(); ++i) {
    length += (path.row(i) - path.row(i - 1)).norm();
  }
  return length;
}

TEST(GuidingPath, IsThePathOfTheModelAwayFromTheEndsOfTheRange) {
  const Model model = OnePointModel();
  const double within = kRangeEnd - kGuidingFadeAngle / 2;
  const double beyond = kRangeEnd + kGuidingFadeAngle / 2;
  for (const double q : {-1.2, within, beyond, 0.4}) {
    const Points path = PathAt(model, q);
    EXPECT_EQ(path.rows(), 3);
    EXPECT_NEAR(LengthOf(path),
                PathLength(model.muscles[0], BodyFrames(model, {q}), {q}),
                1e-9)
        << q;
  }
}

TEST(GuidingPath, NothingJumpsWhereAPointIsSwitched) {
  const Model model = OnePointModel();
  // The path of the model jumps by more than 2 mm at the end of the range.
  const auto model_length = [&](double q) {
    return PathLength(model.muscles[0], BodyFrames(model, {q}), {q});
  };
  ASSERT_GT(std::abs(model_length(-0.5) - model_length(-0.499)), 2);
  // Steps of 1 mrad change no point by more than 0.25 mm: the points of the
  // shank by 0.1, and the switched one by 1.5/0.7 of the 40 mm to its straight
  // place, at most.
  constexpr double kStep = 1e-3;
  for (double q = -1.2; q < 0.2; q += kStep) {
    const Points change = PathAt(model, q + kStep) - PathAt(model, q);
    ASSERT_LT(change.rowwise().norm().maxCoeff(), 0.25) << q;
  }
}

TEST(GuidingPath, PointsStayInOrderOnTheStraightWay) {
  const Model model = ModelWith(OnThigh("a", "0.06 -0.3 0", "-2 -0.5") +
                                OnThigh("b", "0.06 -0.4 0", "-2 -0.5"));
  const Points path = PathAt(model, 0.1);
  ASSERT_EQ(path.rows(), 4);
  EXPECT_NEAR(LengthOf(path), (path.row(3) - path.row(0)).norm(), 1e-9);
  for (int i = 0; i < 3; ++i) {
    EXPECT_GT((path.row(i + 1) - path.row(i)).norm(), 10);
  }
}

TEST(GuidingShare, IsOneForPointsThatAreAlwaysThere) {
  const Model model = OnePointModel();
  EXPECT_EQ(GuidingShare(model, model.muscles[0].path[0], {0.4}), 1);
}

TEST(GuidingShare, FadesOverAtMostHalfOfTheRange) {
  const Model model = ModelWith(OnThigh("p2", "0.06 -0.4 0", "-0.4 0"));
  const PathPoint& point = model.muscles[0].path[1];
  EXPECT_NEAR(GuidingShare(model, point, {-0.5}), 0, 1e-12);
  EXPECT_NEAR(GuidingShare(model, point, {-0.4}), 0.5, 1e-12);
  EXPECT_NEAR(GuidingShare(model, point, {-0.3}), 1, 1e-12);
  EXPECT_NEAR(GuidingShare(model, point, {-0.1}), 1, 1e-12);
  EXPECT_NEAR(GuidingShare(model, point, {0.0}), 0.5, 1e-12);
  EXPECT_NEAR(GuidingShare(model, point, {0.1}), 0, 1e-12);
}

TEST(GuidingShare, RangesWithoutWidthSwitchAtOnce) {
  const Model model = ModelWith(OnThigh("p2", "0.06 -0.4 0", "0.1 0.1"));
  const PathPoint& point = model.muscles[0].path[1];
  EXPECT_EQ(GuidingShare(model, point, {0.1}), 1);
  EXPECT_EQ(GuidingShare(model, point, {0.2}), 0);
}

}  // namespace
}  // namespace musclewarp
