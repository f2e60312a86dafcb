// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/kinematics.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "opensim/read_models.h"

namespace musclewarp {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

const Vector3d kKnee(0, -400, 0);

Eigen::Matrix4d ShankAt(const Model& model, CoordinateValues values) {
  ApplyCouplers(model, &values);
  return BodyFrames(model, values)[kShank];
}

Eigen::Matrix4d FrameOf(const Matrix3d& rotation, const Vector3d& translation) {
  Eigen::Matrix4d frame = Eigen::Matrix4d::Identity();
  frame.topLeftCorner<3, 3>() = rotation;
  frame.topRightCorner<3, 1>() = translation;
  return frame;
}

Matrix3d Turn(double angle, const Vector3d& axis) {
  return AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

const Vector3d kX = Vector3d::UnitX();
const Vector3d kY = Vector3d::UnitY();
const Vector3d kZ = Vector3d::UnitZ();

TEST(Kinematics, JointsMoveAboutTheirAxes) {
  ExpectNear(ShankAt(ReadText(Model4(Joint4("WeldJoint", ""))), {}),
             FrameOf(Matrix3d::Identity(), kKnee));
  ExpectNear(ShankAt(ReadText(Model4(Joint4("PinJoint", "q"))), {0.3}),
             FrameOf(Turn(0.3, kZ), kKnee));
  // Metres of a translational coordinate are mm of the frame.
  ExpectNear(ShankAt(ReadText(Model4(Joint4("SliderJoint", "q"))), {0.02}),
             FrameOf(Matrix3d::Identity(), kKnee + 20 * kX));
  ExpectNear(
      ShankAt(ReadText(Model4(Joint4("UniversalJoint", "a b"))), {0.1, 0.2}),
      FrameOf(Turn(0.1, kX) * Turn(0.2, kY), kKnee));
  const Matrix3d ball = Turn(0.1, kX) * Turn(0.2, kY) * Turn(0.3, kZ);
  for (const char* type : {"BallJoint", "GimbalJoint"}) {
    ExpectNear(
        ShankAt(ReadText(Model4(Joint4(type, "a b c"))), {0.1, 0.2, 0.3}),
        FrameOf(ball, kKnee));
  }
  ExpectNear(ShankAt(ReadText(Model4(Joint4("PlanarJoint", "a b c"))),
                     {0.3, 0.01, 0.02}),
             FrameOf(Turn(0.3, kZ), kKnee + 10 * kX + 20 * kY));
  ExpectNear(ShankAt(ReadText(Model4(Joint4("FreeJoint", "a b c d e f"))),
                     {0.1, 0.2, 0.3, 0.01, 0.02, 0.03}),
             FrameOf(ball, kKnee + Vector3d(10, 20, 30)));
}

TEST(Kinematics, CustomJointsTurnAboutTurnedAxesAndMoveInTheParent) {
  const std::string linear =
      "<LinearFunction><coefficients>2 0.1</coefficients></LinearFunction>";
  const std::string axes =
      Axis4("a", "0 0 3", linear) + Axis4("b", "1 1 0", linear) +
      FreeAxes(2, 3) +
      Axis4("a",
            "0 1 0",
            "<MultiplierFunction><function><PiecewiseLinearFunction><x>0 1</x>"
            "<y>0 1</y></PiecewiseLinearFunction></function><scale>0.5</scale>"
            "</MultiplierFunction>") +
      FreeAxes(4, 6);
  const Model model =
      ReadText(Model4(Joint4("CustomJoint", "a b", SpatialTransform(axes))));
  ExpectNear(
      ShankAt(model, {0.2, -0.3}),
      FrameOf(Turn(0.5, kZ) * Turn(-0.5, Vector3d(1, 1, 0)), kKnee + 100 * kY));
}

TEST(Kinematics, ReversedJointsMoveTheParent) {
  ExpectNear(ShankAt(ReadText(Model3("<reverse>true</reverse>")), {0.3}),
             FrameOf(Turn(-0.3, kZ), kKnee));
}

TEST(Kinematics, OffsetFramesCount) {
  std::string text = Model4(Joint4("PinJoint", "q"));
  // The knee sits on the shank, turned, not at its origin.
  const std::string at = "<translation>0 0 0</translation><orientation>0 0 0";
  text.replace(text.find(at),
               at.size(),
               "<translation>0.1 0 0</translation><orientation>0 0.4 0");
  const Eigen::Matrix4d parent_from_joint =
      FrameOf(Matrix3d::Identity(), kKnee);
  const Eigen::Matrix4d child_from_joint = FrameOf(Turn(0.4, kY), 100 * kX);
  const Eigen::Matrix4d moved = FrameOf(Turn(0.3, kZ), Vector3d::Zero());
  ExpectNear(ShankAt(ReadText(text), {0.3}) * child_from_joint,
             parent_from_joint * moved);
}

TEST(Kinematics, VersionsThreeAndFourAreTheSameModel) {
  const Model three = ReadText(Model3());
  const Model four = ReadText(Model4(Joint4("PinJoint", "knee")));
  ASSERT_EQ(three.coordinates.size(), 1u);
  EXPECT_EQ(three.coordinates[0].name, four.coordinates[0].name);
  EXPECT_EQ(three.coordinates[0].default_value, 0.25);
  EXPECT_EQ(DefaultValues(three)[0], 0.25);
  ExpectNear(ShankAt(three, {0.7}), ShankAt(four, {0.7}));
}

TEST(Kinematics, CoupledCoordinatesFollow) {
  const std::string coupler =
      R"(<CoordinateCouplerConstraint name="c">
        <isEnforced>true</isEnforced>
        <coupled_coordinates_function><LinearFunction>
          <coefficients>0.5 0.1</coefficients>
        </LinearFunction></coupled_coordinates_function>
        <independent_coordinate_names>a</independent_coordinate_names>
        <dependent_coordinate_name>b</dependent_coordinate_name>
        <scale_factor>2</scale_factor>
      </CoordinateCouplerConstraint>)";
  const Model model =
      ReadText(Model4(Joint4("UniversalJoint", "a b"), coupler));
  ExpectNear(ShankAt(model, {0.3, 99}),
             FrameOf(Turn(0.3, kX) * Turn(2 * (0.5 * 0.3 + 0.1), kY), kKnee));
  EXPECT_TRUE(MovesBody(model, 0, kShank));
  EXPECT_FALSE(MovesBody(model, 0, 1));
  EXPECT_EQ(FreeCoordinates(model), std::vector<int>{0});
  std::string off = coupler;
  off.replace(off.find("true"), 4, "false");
  ExpectNear(ShankAt(ReadText(Model4(Joint4("UniversalJoint", "a b"), off)),
                     {0.3, 0.5}),
             FrameOf(Turn(0.3, kX) * Turn(0.5, kY), kKnee));
}

TEST(Kinematics, LockedCoordinatesAreNotFree) {
  std::string text = Model4(Joint4("UniversalJoint", "a b"));
  EXPECT_EQ(FreeCoordinates(ReadText(text)), (std::vector<int>{0, 1}));
  const std::string open = "<Coordinate name=\"a\"/>";
  text.replace(text.find(open),
               open.size(),
               "<Coordinate name=\"a\"><locked>true</locked></Coordinate>");
  EXPECT_EQ(FreeCoordinates(ReadText(text)), std::vector<int>{1});
}

// A muscle from the thigh over a point that is only there while the knee is
// flexed, to one on the shank that moves with the knee.
Model ModelWithPath() {
  const std::string moving = R"(<MovingPathPoint name="p3">
      <socket_parent_frame>/bodyset/shank</socket_parent_frame>
      <socket_x_coordinate>/jointset/knee_joint/q</socket_x_coordinate>
      <socket_y_coordinate>/jointset/knee_joint/q</socket_y_coordinate>
      <x_location><LinearFunction><coefficients>0.01 0.03</coefficients>
        </LinearFunction></x_location>
      <y_location><Constant><value>-0.1</value></Constant></y_location>
      <z_location><Constant><value>0</value></Constant></z_location>
    </MovingPathPoint>)";
  return ReadText(
      Model4(Joint4("PinJoint", "q"),
             "",
             Muscle("m",
                    Point4("p1", "thigh", "0.02 -0.1 0") +
                        Point4("p2",
                               "thigh",
                               "0.06 -0.4 0",
                               "ConditionalPathPoint",
                               "<socket_coordinate>/jointset/knee_joint/q"
                               "</socket_coordinate><range>-2 -0.5</range>") +
                        moving)));
}

double LengthAt(const Model& model, double q) {
  return PathLength(model.muscles[0], BodyFrames(model, {q}), {q});
}

TEST(Kinematics, PathsRunOverTheirActivePoints) {
  const Model model = ModelWithPath();
  ASSERT_EQ(model.muscles[0].path.size(), 3u);
  const Vector3d first(20, -100, 0);
  const Vector3d second(60, -400, 0);
  const auto last = [](double q) -> Vector3d {
    return kKnee + Turn(q, kZ) * Vector3d(30 + 10 * q, -100, 0);
  };
  EXPECT_NEAR(
      LengthAt(model, 0.2), (last(0.2) - first).norm(), kTransformRounding);
  EXPECT_NEAR(LengthAt(model, -1),
              (second - first).norm() + (last(-1) - second).norm(),
              kTransformRounding);
  // The range has OpenSim's slack of 1e-5.
  EXPECT_TRUE(IsActive(model.muscles[0].path[1], {-0.5 + 0.9e-5}));
  EXPECT_FALSE(IsActive(model.muscles[0].path[1], {-0.5 + 1.1e-5}));
}

TEST(Kinematics, MomentArmsAreTheSlopeOfTheLength) {
  const Model model = ModelWithPath();
  constexpr double kStep = 1e-3;
  // Differences over the step are off by its square times the third derivative
  // over 6, some 100 mm/rad^3.
  constexpr double kTolerance = 1e-4;
  for (const double q : {-1.5, -0.8, 0.1, 0.9}) {
    const double slope =
        (LengthAt(model, q + kStep) - LengthAt(model, q - kStep)) / (2 * kStep);
    EXPECT_NEAR(
        PathMomentArm(model, model.muscles[0], 0, {q}), -slope, kTolerance);
  }
  // Where the condition switches, from the side that it is on.
  const double at_switch = PathMomentArm(model, model.muscles[0], 0, {-0.5});
  const double before = PathMomentArm(model, model.muscles[0], 0, {-0.501});
  EXPECT_NEAR(at_switch, before, 0.5);
}

TEST(Kinematics, UnsupportedPartsMatterOnlyWhereTheyAreNeeded) {
  const Model model = ReadText(Model4(Joint4("EllipsoidJoint", "q")));
  CheckBodyIsSupported(model, 1, "the scene");
  ExpectInputError([&] { CheckBodyIsSupported(model, kShank, "the scene"); },
                   {"leg.osim",
                    "\"shank\", which the scene needs",
                    "EllipsoidJoint \"knee_joint\"",
                    "line"});
  const Model gcv = ReadText(Model4(Joint4(
      "CustomJoint",
      "q",
      SpatialTransform(Axis4("q", "0 0 1", "<GCVSpline/>") + FreeAxes(1, 6)))));
  ExpectInputError([&] { CheckBodyIsSupported(gcv, kShank, "the scene"); },
                   {"<GCVSpline>"});
}

}  // namespace
}  // namespace musclewarp
