// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/perturbed_poses.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "scene/transform_checks.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

// Of differences of places of some hundred mm over 2e-4 rad, by rad.
constexpr double kRateRounding = 1e-8;

// A leg whose knee turns about x by "a" and about y by "b".
ModelPoses LegPoses(const std::string& constraints = "") {
  const std::string file =
      Written("leg.osim", Model4(Joint4("UniversalJoint", "a b"), constraints));
  ModelRest rest;
  rest.coordinates = {{"a", 0.0}};
  std::vector<std::string> notes;
  return BindModel(ReadModel(file), rest, {"thigh", "shank"}, file, &notes);
}

TEST(MomentArmCoordinates, AreThoseThatAreFreeOrMove) {
  ModelPoses poses = LegPoses();
  EXPECT_EQ(MomentArmCoordinates(poses), (std::vector<int>{0, 1}));
  poses.model.coordinates[0].is_locked = true;
  EXPECT_EQ(MomentArmCoordinates(poses), std::vector<int>{1});
  poses.moving_coordinates = {0};
  EXPECT_EQ(MomentArmCoordinates(poses), (std::vector<int>{0, 1}));
}

TEST(PerturbedPosesOf, AreOnBothSidesAndTakeCoupledCoordinatesAlong) {
  const ModelPoses poses = LegPoses(
      R"(<CoordinateCouplerConstraint name="c">
        <coupled_coordinates_function><LinearFunction>
          <coefficients>0.5 0.1</coefficients>
        </LinearFunction></coupled_coordinates_function>
        <independent_coordinate_names>a</independent_coordinate_names>
        <dependent_coordinate_name>b</dependent_coordinate_name>
      </CoordinateCouplerConstraint>)");
  CoordinateValues values = {0.3, 0};
  ApplyCouplers(poses.model, &values);
  const auto beside = PerturbedPosesOf(poses, PoseAt(poses, values));
  ASSERT_EQ(beside.size(), 1u);
  EXPECT_EQ(beside[0].name, "a");
  EXPECT_EQ(beside[0].before.model_values[0], 0.3 - PerturbedPoses::kStep);
  EXPECT_EQ(beside[0].after.model_values[0], 0.3 + PerturbedPoses::kStep);
  EXPECT_EQ(beside[0].after.model_values[1],
            0.5 * (0.3 + PerturbedPoses::kStep) + 0.1);
  EXPECT_LT(Difference(
                beside[0].after.bodies.at("shank"),
                PoseAt(poses, beside[0].after.model_values).bodies.at("shank")),
            kTransformRounding);
}

TEST(RateBetween, IsTheVelocityOfAScrewMotion) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, -2) / 3;
  const Eigen::Vector3d through(300, -200, 500);
  const auto place = [&](double q) {
    Eigen::Isometry3d turned = Eigen::Translation3d(through) *
                               Eigen::AngleAxisd(q, axis) *
                               Eigen::Translation3d(-through);
    turned.pretranslate(Eigen::Vector3d(40 * q * axis));
    return Eigen::Isometry3d(turned * Eigen::Translation3d(7, 8, 9) *
                             Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX()))
        .matrix();
  };
  const Eigen::Matrix4d rate = RateBetween(place(0.7 - PerturbedPoses::kStep),
                                           place(0.7 + PerturbedPoses::kStep));
  const Eigen::Vector3d point(-100, 50, 80);
  const Eigen::Vector3d expected = axis.cross(point - through) + 40 * axis;
  EXPECT_LT(((rate * point.homogeneous()).head<3>() - expected).norm(),
            kRateRounding);
  EXPECT_EQ(rate.row(3).norm(), 0);
  EXPECT_LT(RateBetween(place(0.7), place(0.7)).norm(), kRateRounding);
}

}  // namespace
}  // namespace musclewarp
