// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "musclewarp/opensim/function.h"

namespace musclewarp {

// The parts of an OpenSim model that determine the motion of bodies and muscle
// paths. Lengths are in mm, although files have metres. Coordinates keep the
// units of OpenSim: rad, or m if they are translational. The parts refer to
// each other by index into the lists of Model; -1 means none.
//
//   const Model model = ReadModel("leg.osim");
//   const CoordinateValues values = DefaultValues(model);
//   const auto ground_from_body = BodyFrames(model, values);

// Files have metres.
constexpr double kMillimetresPerMetre = 1000;

// What a coordinate measures, which decides about its unit.
enum class CoordinateKind {
  kRotational,     // an angle, which tables may give in degrees
  kTranslational,  // a length, m
  kCoupled,        // neither; its values are taken as they are
};

// A degree of freedom of a joint.
struct Coordinate {
  // A name that no other coordinate of the model has: where two joints have one
  // of the same name, that of the joint and of the coordinate, as in
  // "freejoint_1/rx".
  std::string name;

  std::string joint;  // the name of its joint
  CoordinateKind kind = CoordinateKind::kRotational;
  double default_value = 0;

  // The values that it is meant for, rad or m; none if the model does not say.
  std::optional<std::array<double, 2>> range;
  bool is_clamped = false;  // true if OpenSim keeps it in the range

  // True if the model holds the coordinate at its default value. A motion may
  // move it all the same.
  bool is_locked = false;
};

// A constraint that makes a coordinate follow others:
// dependent = scale * function(independents).
struct CoordinateCoupler {
  std::string name;
  int dependent = -1;
  std::vector<int> independents;
  FunctionPtr function;
  double scale = 1;
};

// A rotation about an axis of a joint, or a translation along it, by
// function(coordinates).
struct TransformAxis {
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();  // of unit length
  std::vector<int> coordinates;
  FunctionPtr function;  // rad or mm; null if nothing moves
};

// A joint connects a child body to its parent. Every joint is represented as
// OpenSim's SpatialTransform: three rotations, each about an axis that the ones
// before have turned, then three translations in the frame of the parent. Pins,
// sliders and the other simple types are special cases with axes of their own.
struct Joint {
  std::string name;
  std::string type;  // the name of its element, such as "PinJoint"
  int parent = -1;
  int child = -1;

  // The places of the joint on both bodies; X_PF and X_BM in the terms of
  // Simbody.
  Eigen::Matrix4d parent_from_joint;
  Eigen::Matrix4d child_from_joint;

  std::array<TransformAxis, 3> rotations, translations;

  // If true, the axes describe the motion of the parent relative to the child.
  bool is_reversed = false;

  // Why the motion of the joint is not known, such as "the function <GCVSpline>
  // in line 12". Empty if it is known.
  std::string unsupported;
};

// A mesh that is attached to a body. A point p of the mesh is at
// body_from_mesh * (1000 * scale * p) in the frame of the body (mm), as files
// have metres.
struct ModelGeometry {
  std::string file;  // as the model names it, with forward slashes
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Matrix4d body_from_mesh = Eigen::Matrix4d::Identity();
};

// A rigid segment of the skeleton, such as the femur.
struct Body {
  std::string name;

  // The joint of which the body is the child, or -1 for the ground and for a
  // body without a joint.
  int joint = -1;

  std::vector<ModelGeometry> geometry;
};

// A point of the path of a muscle. It is fixed to its body unless is_moving is
// true, and always part of the path unless it has a condition.
struct PathPoint {
  std::string name;
  int body = -1;

  // The location of a fixed point in the frame of the body, mm.
  Eigen::Vector3d location = Eigen::Vector3d::Zero();

  // The location of a moving point. In a frame on the body, coordinate i of the
  // point is moving_functions[i] (mm) of the value of moving_coordinates[i],
  // which is -1 for a constant function.
  bool is_moving = false;
  std::array<int, 3> moving_coordinates = {-1, -1, -1};
  std::array<FunctionPtr, 3> moving_functions;
  Eigen::Matrix4d body_from_frame = Eigen::Matrix4d::Identity();

  // The coordinate on which a conditional point depends, -1 for other points.
  // The point is part of the path while the coordinate is in the range.
  int condition = -1;
  double range[2] = {0, 0};
};

// The path of a muscle from its origin to its insertion. Ligaments and other
// forces with a path are muscles, too.
struct ModelMuscle {
  std::string name;
  std::vector<PathPoint> path;

  // The length of a path that is a function of coordinates instead of points
  // (FunctionBasedPath of OpenSim 4.5), in m, and its arguments. The function
  // is null for a path of points.
  FunctionPtr length_function;
  std::vector<int> length_coordinates;

  // Why the path is not known, as for joints. Empty if it is known.
  std::string unsupported;
};

// A model as ReadModel returns it.
struct Model {
  std::string path;  // of its file
  std::string text;  // of its file, from which ModelFromText() makes it again
  std::string name;
  std::vector<Body> bodies;  // the ground comes first
  std::vector<Joint> joints;
  std::vector<Coordinate> coordinates;
  std::vector<CoordinateCoupler> couplers;
  std::vector<ModelMuscle> muscles;

  // What the file has and this project ignores, such as wrapping and
  // constraints. Each kind is mentioned once.
  std::vector<std::string> warnings;

  // Return the index of the part with a name, or -1 if there is none. A
  // coordinate may also be named by its path, of which that of the model comes
  // first and "value" last, as in "/jointset/knee_r/knee_angle_r/value"; and of
  // two muscles of one name the first is found.
  int FindBody(const std::string& body) const;
  int FindCoordinate(const std::string& coordinate) const;
  int FindMuscle(const std::string& muscle) const;

  // Returns the names of the coordinates that are told apart by their joints
  // and would otherwise have this name: none or at least two.
  std::vector<std::string> CoordinatesCalled(
      const std::string& last_name) const;
};

// Says why FindCoordinate() has none of this name, as the end of a sentence
// that begins with it: "is not a coordinate of the model", or that joints have
// several of the name.
std::string WhyNoCoordinate(const Model& model, const std::string& name);

// The bodies, joints and muscles that a model may have of each. The largest
// published ones have some hundreds.
constexpr std::size_t kMostModelParts = 5000;

// Reads a model of OpenSim 2 to 4 from an .osim file.
//
// Throws InputError, which names the file, the line and the element, if the
// file is not well-formed XML, if an element is missing or is not a number, if
// a name refers to nothing, if the joints of bodies form a cycle, or if there
// are more parts than are allowed. Joints and functions that are not supported,
// and frames that are not known, are errors only where they are needed; see
// CheckBodyIsSupported.
Model ReadModel(const std::string& path);

// Does the same with the contents of a file. `path` is for messages, and the
// place from which the model names other files.
Model ModelFromText(std::string text, const std::string& path);

}  // namespace musclewarp
