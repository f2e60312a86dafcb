// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/mjcf_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/base/random_draws.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

using Eigen::Matrix4d;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

// Places and turns of bodies, m and their cosines.
constexpr double kPlaceRounding = 1e-9;

CoordinateValues Low(const Model& model) {
  return CoordinateValues(model.coordinates.size(), -0.5);
}
CoordinateValues High(const Model& model) {
  return CoordinateValues(model.coordinates.size(), 0.8);
}

// Where the rules of MuJoCo place the bodies: joints act one after the other,
// each in the frame that those before have moved.
std::vector<Matrix4d> PlacedByMujoco(const MjcfTree& tree,
                                     const std::map<std::string, double>& q) {
  std::vector<Matrix4d> placed;
  for (const MjcfBody& body : tree.bodies) {
    Matrix4d here =
        body.parent < 0 ? Matrix4d::Identity() : placed[body.parent];
    here = here * body.parent_from_body;
    for (const MjcfJoint& joint : body.joints) {
      const double value = q.at(joint.name);
      Matrix4d step = Matrix4d::Identity();
      if (joint.is_hinge) {
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(value, joint.axis).matrix();
        step.topLeftCorner<3, 3>() = turn;
        step.topRightCorner<3, 1>() = joint.anchor - turn * joint.anchor;
      } else {
        step.topRightCorner<3, 1>() = value * joint.axis;
      }
      here = here * step;
    }
    placed.push_back(here);
  }
  return placed;
}

// The values of all joints: those of coordinates, and those that follow.
std::map<std::string, double> JointValues(const Model& model,
                                          const MjcfTree& tree,
                                          const CoordinateValues& values) {
  std::map<std::string, double> q;
  for (size_t c = 0; c < values.size(); ++c) {
    q[model.coordinates[c].name] = values[c];
  }
  for (const MjcfCoupling& coupling : tree.couplings) {
    const double x = coupling.of.empty() ? 0 : q.at(coupling.of);
    double value = 0, power = 1;
    for (const double coefficient : coupling.coefficients) {
      value += coefficient * power;
      power *= x;
    }
    q[coupling.joint] = value;
  }
  return q;
}

// Law: the bodies are where OpenSim has them, in any posture.
void ExpectSamePlaces(const Model& model, double tolerance = kPlaceRounding) {
  const MjcfTree tree = MakeMjcfTree(model, Low(model), High(model));
  EXPECT_THAT(tree.notes, IsEmpty());
  RandomDraws draws(1);
  for (int i = 0; i < 20; ++i) {
    CoordinateValues values;
    for (size_t c = 0; c < model.coordinates.size(); ++c) {
      values.push_back(draws.Uniform(-0.4, 0.7));
    }
    ApplyCouplers(model, &values);
    const auto expected = BodyFrames(model, values);
    const auto placed = PlacedByMujoco(tree, JointValues(model, tree, values));
    for (size_t b = 0; b < placed.size(); ++b) {
      if (tree.bodies[b].model_body < 0) continue;
      Matrix4d frame = expected[tree.bodies[b].model_body];
      frame.topRightCorner<3, 1>() /= 1000;
      EXPECT_LT((placed[b] - frame).cwiseAbs().maxCoeff(), tolerance)
          << tree.bodies[b].name;
    }
  }
}

Model ModelWith(const std::string& joint, const std::string& constraints = "") {
  return ReadModel(Written("leg.osim", Model4(joint, constraints)));
}

TEST(MjcfTree, PlacesBodiesAsOpenSimDoes) {
  for (const auto& [type, coordinates] :
       std::map<std::string, std::string>{{"PinJoint", "a"},
                                          {"SliderJoint", "a"},
                                          {"UniversalJoint", "a b"},
                                          {"BallJoint", "a b c"},
                                          {"GimbalJoint", "a b c"},
                                          {"PlanarJoint", "a b c"},
                                          {"FreeJoint", "a b c d e f"}}) {
    SCOPED_TRACE(type);
    ExpectSamePlaces(ModelWith(Joint4(type, coordinates)));
  }
}

TEST(MjcfTree, TurnsAboutNegativeAxesAndOffsets) {
  const std::string axes = SpatialTransform(
      Axis4("a",
            "0.6 0.8 0",
            "<LinearFunction><coefficients>-1 0.3</coefficients>"
            "</LinearFunction>") +
      Axis4("b",
            "0 0 1",
            "<LinearFunction><coefficients>1 -0.2</coefficients>"
            "</LinearFunction>") +
      Axis4("", "1 0 0", "<Constant><value>0.4</value></Constant>") +
      FreeAxes(3, 6));
  ExpectSamePlaces(ModelWith(Joint4("CustomJoint", "a b", axes)));
}

// A spline is a polynomial of the fourth degree to some thousandths of a m.
TEST(MjcfTree, FollowsSplines) {
  const std::string spline =
      "<SimmSpline><x>-0.6 -0.2 0.3 0.6 0.9</x><y>0.002 0 0.001 0.003 0.004"
      "</y></SimmSpline>";
  const std::string axes = SpatialTransform(
      Axis4("a",
            "1 0 0",
            "<LinearFunction><coefficients>1 0</coefficients>"
            "</LinearFunction>") +
      FreeAxes(1, 3) + Axis4("a", "1 0 0", spline) + FreeAxes(4, 6));
  const Model model = ModelWith(Joint4("CustomJoint", "a", axes));
  const MjcfTree tree = MakeMjcfTree(model, Low(model), High(model));
  ASSERT_THAT(tree.couplings, SizeIs(1));
  EXPECT_EQ(tree.couplings[0].of, "a");
  EXPECT_GT(tree.couplings[0].largest_error, 0);
  ExpectSamePlaces(model, tree.couplings[0].largest_error + kPlaceRounding);
}

TEST(MjcfTree, FollowsCouplers) {
  const std::string coupler =
      R"(<CoordinateCouplerConstraint name="c"><coupled_coordinates_function>
      <LinearFunction><coefficients>2 0.1</coefficients></LinearFunction>
      </coupled_coordinates_function>
      <independent_coordinate_names>b</independent_coordinate_names>
      <dependent_coordinate_name>c</dependent_coordinate_name>
      </CoordinateCouplerConstraint>)";
  const Model model = ModelWith(Joint4("PlanarJoint", "a b c"), coupler);
  ExpectSamePlaces(model);
}

// A coordinate of which only a function moves anything.
TEST(MjcfTree, GivesEveryCoordinateAJoint) {
  const std::string axes = SpatialTransform(
      Axis4("a",
            "1 0 0",
            "<LinearFunction><coefficients>0.5 0</coefficients>"
            "</LinearFunction>") +
      FreeAxes(1, 6));
  const Model model = ModelWith(Joint4("CustomJoint", "a", axes));
  const MjcfTree tree = MakeMjcfTree(model, Low(model), High(model));
  EXPECT_EQ(tree.bodies.back().name, "coordinate_a");
  EXPECT_EQ(tree.bodies.back().joints[0].name, "a");
  ExpectSamePlaces(model);
}

TEST(MjcfTree, SaysWhatItCannotTakeOver) {
  const Model model = ModelWith(Joint4("EllipsoidJoint", "a b c"));
  const MjcfTree tree = MakeMjcfTree(model, Low(model), High(model));
  ASSERT_FALSE(tree.notes.empty());
  EXPECT_THAT(tree.notes[0], HasSubstr("does not move"));
}

}  // namespace
}  // namespace musclewarp
