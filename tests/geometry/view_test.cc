// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/geometry/view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "musclewarp/base/input_error.h"

namespace musclewarp {
namespace {

using Eigen::Vector3d;

// Two operations on unit vectors.
constexpr double kDirectionRounding = 1e-15;

// What lies on the viewer's right.
Vector3d RightOf(const View& view) { return view.up.cross(view.toward_viewer); }

std::string ErrorOf(const std::string& name,
                    const std::string& axes,
                    const std::string& side) {
  try {
    ParseView(name, axes, side);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(View, FromTheFrontTheLeftOfTheBodyIsOnTheRight) {
  const View view = ParseView("anterior", "LPS", "right");
  EXPECT_EQ(view.toward_viewer, -Vector3d::UnitY());
  EXPECT_EQ(view.up, Vector3d::UnitZ());
  EXPECT_EQ(RightOf(view), Vector3d::UnitX());
}

TEST(View, EveryNameIsSeenFromWhereItSays) {
  const auto from = [](const char* name, const char* side) {
    return ParseView(name, "LPS", side).toward_viewer;
  };
  EXPECT_EQ(from("posterior", "right"), Vector3d::UnitY());
  EXPECT_EQ(from("left", "right"), Vector3d::UnitX());
  EXPECT_EQ(from("right", "right"), -Vector3d::UnitX());
  EXPECT_EQ(from("superior", "right"), Vector3d::UnitZ());
  EXPECT_EQ(from("inferior", "right"), -Vector3d::UnitZ());
  EXPECT_EQ(from("lateral", "right"), from("right", "right"));
  EXPECT_EQ(from("medial", "right"), from("left", "right"));
  EXPECT_EQ(from("lateral", "left"), from("left", "right"));
  EXPECT_EQ(from("medial", "left"), from("right", "right"));
}

TEST(View, FollowsTheAxesOfTheMeshes) {
  // OpenSim: +x forward, +y up, +z right.
  const View view = ParseView("lateral", "ASR", "right");
  EXPECT_EQ(view.toward_viewer, Vector3d::UnitZ());
  EXPECT_EQ(view.up, Vector3d::UnitY());
}

TEST(View, VectorsAreMadePerpendicular) {
  const View view = ParseView("3,-4,0;0,-1,1", "LPS", "right");
  EXPECT_TRUE(
      view.toward_viewer.isApprox(Vector3d(0.6, -0.8, 0), kDirectionRounding));
  EXPECT_NEAR(view.up.norm(), 1, kDirectionRounding);
  EXPECT_NEAR(view.up.dot(view.toward_viewer), 0, kDirectionRounding);
  EXPECT_GT(view.up.z(), 0);
  // Without an upward direction: superior.
  EXPECT_EQ(ParseView("1,0,0", "LPS", "right").up, Vector3d::UnitZ());
}

TEST(View, MistakesNameTheFlag) {
  using ::testing::HasSubstr;
  EXPECT_THAT(ErrorOf("front", "LPS", "right"), HasSubstr("view: 'front'"));
  EXPECT_THAT(ErrorOf("1,2", "LPS", "right"), HasSubstr("view"));
  EXPECT_THAT(ErrorOf("0,0,0", "LPS", "right"), HasSubstr("view"));
  EXPECT_THAT(ErrorOf("1,0,0 ", "LPS", "right"), HasSubstr("view"));
  EXPECT_THAT(ErrorOf("0,0,1", "LPS", "right"), HasSubstr("upward"));
  EXPECT_THAT(ErrorOf("anterior", "LPR", "right"), HasSubstr("axes: 'LPR'"));
  EXPECT_THAT(ErrorOf("anterior", "LPSS", "right"), HasSubstr("axes"));
  EXPECT_THAT(ErrorOf("anterior", "XYZ", "right"), HasSubstr("axes"));
  EXPECT_THAT(ErrorOf("lateral", "LPS", "both"), HasSubstr("side: 'both'"));
}

}  // namespace
}  // namespace musclewarp
