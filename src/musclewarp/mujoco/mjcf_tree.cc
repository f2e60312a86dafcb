// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/mjcf_tree.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector3d;

Matrix4d InMetres(Matrix4d transform) {
  transform.topRightCorner<3, 1>() *= kMetresPerMillimetre;
  return transform;
}

Matrix4d TurnBy(const Vector3d& axis, double angle) {
  Matrix4d turn = Matrix4d::Identity();
  turn.topLeftCorner<3, 3>() = Eigen::AngleAxisd(angle, axis).matrix();
  return turn;
}

Matrix4d MoveBy(const Vector3d& move) {
  Matrix4d result = Matrix4d::Identity();
  result.topRightCorner<3, 1>() = move;
  return result;
}

// A function of one coordinate over its range.
struct CoordinateFunction {
  const Function* function = nullptr;
  double scale = 1;
  double low = 0, high = 0;

  double operator()(double q) const { return scale * function->Value({q}); }
};

// Returns the polynomial of the fourth degree through a function, by least
// squares at Chebyshev points, which keeps the largest error small.
MjcfCoupling CouplingTo(const std::string& joint,
                        const std::string& of,
                        const CoordinateFunction& function) {
  constexpr int kPoints = 60;
  MjcfCoupling coupling = {joint, of};
  const double middle = (function.low + function.high) / 2;
  const double half = (function.high - function.low) / 2;
  Eigen::MatrixXd rows(kPoints, 5);
  Eigen::VectorXd values(kPoints);
  for (int i = 0; i < kPoints; ++i) {
    const double q = middle + half * std::cos(M_PI * (i + 0.5) / kPoints);
    double power = 1;
    for (int n = 0; n < 5; ++n, power *= q) rows(i, n) = power;
    values[i] = function(q);
  }
  const Eigen::VectorXd solution =
      Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(rows).solve(
          values);
  for (int n = 0; n < 5; ++n) coupling.coefficients[n] = solution[n];
  coupling.largest_error = (rows * solution - values).cwiseAbs().maxCoeff();
  return coupling;
}

// Slope and offset of a function that is a line, as nearly as rounding lets it.
std::optional<std::array<double, 2>> LineOf(
    const CoordinateFunction& function) {
  constexpr double kRounding = 1e-12;
  constexpr int kPoints = 16;
  const double offset = function(0);
  const double slope = function(1) - offset;
  for (int i = 0; i <= kPoints; ++i) {
    const double q =
        function.low + (function.high - function.low) * i / kPoints;
    const double line = offset + slope * q;
    if (std::abs(function(q) - line) > kRounding * (1 + std::abs(line))) {
      return std::nullopt;
    }
  }
  return std::array<double, 2>{slope, offset};
}

// Makes the tree, body by body.
class TreeMaker {
 public:
  TreeMaker(const Model& model,
            const CoordinateValues& low,
            const CoordinateValues& high)
      : model_(model), low_(low), high_(high) {
    for (size_t c = 0; c < model.coordinates.size(); ++c) {
      const auto& range = model.coordinates[c].range;
      if (!range) continue;
      low_[c] = std::min(low_[c], (*range)[0]);
      high_[c] = std::max(high_[c], (*range)[1]);
    }
    has_joint_.assign(model.coordinates.size(), 0);
    places_.assign(model.bodies.size(), -1);
  }

  MjcfTree Make() {
    // The ground is the world.
    for (size_t b = 1; b < model_.bodies.size(); ++b) {
      AddBody(static_cast<int>(b));
    }
    AddMissingCoordinates();
    AddCouplers();
    return std::move(tree_);
  }

 private:
  // Adds a body after its parents, and returns its place in the tree.
  int AddBody(int index) {
    if (index <= 0) return -1;
    if (places_[index] >= 0) return places_[index];
    const Body& body = model_.bodies[index];
    MjcfBody added;
    added.name = body.name;
    added.model_body = index;
    if (body.joint >= 0) {
      const Joint& joint = model_.joints[body.joint];
      added.parent = AddBody(joint.parent);
      if (joint.unsupported.empty()) {
        AddJoints(joint, &added);
      } else {
        tree_.notes.push_back("the body " + body.name + " does not move: " +
                              joint.unsupported + " is not supported");
      }
    }
    places_[index] = static_cast<int>(tree_.bodies.size());
    tree_.bodies.push_back(std::move(added));
    return places_[index];
  }

  // One axis of a joint, in the order in which MuJoCo moves them.
  struct Axis {
    const TransformAxis* axis;
    bool turns;
    std::string label;
  };

  static std::vector<Axis> AxesOf(const Joint& joint) {
    std::vector<Axis> axes;
    for (int k = 0; k < 3; ++k) {
      axes.push_back({&joint.translations[k],
                      false,
                      joint.name + "_translation" + std::to_string(k + 1)});
    }
    for (int k = 0; k < 3; ++k) {
      axes.push_back({&joint.rotations[k],
                      true,
                      joint.name + "_rotation" + std::to_string(k + 1)});
    }
    // The inverse of a motion undoes its parts from the last one on.
    if (joint.is_reversed) std::reverse(axes.begin(), axes.end());
    return axes;
  }

  // A joint before the place of the body is known.
  struct PlacedJoint {
    MjcfJoint joint;
    Matrix4d frame;  // in which its axis is given, from that of the parent
    Vector3d axis;
  };

  void AddJoints(const Joint& joint, MjcfBody* body) {
    const double sense = joint.is_reversed ? -1 : 1;
    Matrix4d here = InMetres(joint.parent_from_joint);
    std::vector<PlacedJoint> placed;
    for (const Axis& axis : AxesOf(joint)) {
      if (!axis.axis->function) continue;
      const double unit = axis.turns ? 1 : kMetresPerMillimetre;
      const Vector3d direction = sense * axis.axis->axis;
      const auto by = [&](double value) {
        return axis.turns ? TurnBy(direction, value)
                          : MoveBy(value * direction);
      };
      if (axis.axis->coordinates.empty()) {
        here = here * by(unit * axis.axis->function->Value({}));
        continue;
      }
      const double fixed = AddAxis(axis, unit, here, direction, &placed);
      here = here * by(fixed);
    }
    body->parent_from_body =
        here * InMetres(RigidInverse(joint.child_from_joint));
    const Matrix4d body_from_parent = RigidInverse(body->parent_from_body);
    for (PlacedJoint& one : placed) {
      const Matrix4d body_from_frame = body_from_parent * one.frame;
      one.joint.axis = body_from_frame.topLeftCorner<3, 3>() * one.axis;
      one.joint.anchor = body_from_frame.topRightCorner<3, 1>();
      body->joints.push_back(std::move(one.joint));
    }
  }

  // Adds the joint of an axis, and returns the value at which its own is 0.
  double AddAxis(const Axis& axis,
                 double unit,
                 const Matrix4d& frame,
                 const Vector3d& direction,
                 std::vector<PlacedJoint>* placed) {
    const std::vector<int>& coordinates = axis.axis->coordinates;
    const int index = coordinates[0];
    const Coordinate& coordinate = model_.coordinates[index];
    if (coordinates.size() > 1) {
      std::vector<double> defaults;
      const CoordinateValues values = DefaultValues(model_);
      for (const int c : coordinates) defaults.push_back(values[c]);
      tree_.notes.push_back(axis.label +
                            " depends on several coordinates, which MuJoCo "
                            "does not have; it stays at its default");
      return unit * axis.axis->function->Value(defaults);
    }
    const CoordinateFunction function = {
        axis.axis->function.get(), unit, low_[index], high_[index]};
    const auto line = LineOf(function);
    constexpr double kRounding = 1e-9;
    const bool is_own =
        line && std::abs(std::abs((*line)[0]) - 1) < kRounding &&
        !has_joint_[index] &&
        axis.turns == (coordinate.kind != CoordinateKind::kTranslational);
    MjcfJoint joint;
    joint.is_hinge = axis.turns;
    if (is_own) {
      has_joint_[index] = 1;
      SetCoordinate(index, &joint);
      placed->push_back(
          {joint, frame, (*line)[0] < 0 ? Vector3d(-direction) : direction});
      return (*line)[1];
    }
    joint.name = axis.label;
    joint.default_value = function(DefaultValues(model_)[index]);
    placed->push_back({joint, frame, direction});
    tree_.couplings.push_back(
        CouplingTo(axis.label, coordinate.name, function));
    return 0;
  }

  void SetCoordinate(int index, MjcfJoint* joint) const {
    const Coordinate& coordinate = model_.coordinates[index];
    joint->name = coordinate.name;
    joint->default_value = DefaultValues(model_)[index];
    if (coordinate.is_clamped) joint->range = coordinate.range;
  }

  // Coordinates of which only functions move anything.
  void AddMissingCoordinates() {
    for (size_t c = 0; c < has_joint_.size(); ++c) {
      if (has_joint_[c]) continue;
      MjcfBody body;
      body.name = "coordinate_" + model_.coordinates[c].name;
      MjcfJoint& joint = body.joints.emplace_back();
      SetCoordinate(static_cast<int>(c), &joint);
      joint.is_hinge =
          model_.coordinates[c].kind != CoordinateKind::kTranslational;
      joint.axis = Vector3d::UnitX();
      joint.anchor.setZero();
      tree_.bodies.push_back(std::move(body));
    }
  }

  void AddCouplers() {
    for (const CoordinateCoupler& coupler : model_.couplers) {
      const std::string& name = model_.coordinates[coupler.dependent].name;
      if (coupler.independents.size() != 1) {
        tree_.notes.push_back(name +
                              " follows several coordinates, which MuJoCo does "
                              "not have; it is free");
        continue;
      }
      const int of = coupler.independents[0];
      tree_.couplings.push_back(CouplingTo(
          name,
          model_.coordinates[of].name,
          {coupler.function.get(), coupler.scale, low_[of], high_[of]}));
    }
    const CoordinateValues defaults = DefaultValues(model_);
    for (size_t c = 0; c < model_.coordinates.size(); ++c) {
      if (!model_.coordinates[c].is_locked) continue;
      tree_.couplings.push_back(
          {model_.coordinates[c].name, "", {defaults[c], 0, 0, 0, 0}, 0});
    }
  }

  const Model& model_;
  CoordinateValues low_, high_;
  std::vector<char> has_joint_;  // by coordinate
  std::vector<int> places_;      // of bodies in the tree
  MjcfTree tree_;
};

}  // namespace

MjcfTree MakeMjcfTree(const Model& model,
                      const CoordinateValues& low,
                      const CoordinateValues& high) {
  return TreeMaker(model, low, high).Make();
}

}  // namespace musclewarp
