// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "musclewarp/opensim/function.h"

namespace musclewarp {

// An OpenSim model, as far as the motion of bodies and muscle paths goes.
// Lengths are in mm (files hold metres). Coordinates keep OpenSim's units: rad,
// or m where they are translational. Everything refers to each other by index.

enum class CoordinateKind {
  kRotational,
  kTranslational,
  kCoupled,  // neither; not converted between degrees and radians
};

struct Coordinate {
  std::string name;
  CoordinateKind kind = CoordinateKind::kRotational;
  double default_value = 0;
};

// A coordinate that is a function of others, times a scale.
struct CoordinateCoupler {
  std::string name;
  int dependent = -1;
  std::vector<int> independents;
  FunctionPtr function;
  double scale = 1;
};

// One rotation about, or translation along, an axis of a joint.
struct TransformAxis {
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();  // unit length
  std::vector<int> coordinates;
  FunctionPtr function;  // rad, or mm; null: none
};

// Every joint is a SpatialTransform: three rotations, each about the axes the
// one before has turned, then a translation in the parent's frame. Pins,
// sliders and so on are such with axes of their own.
struct Joint {
  std::string name;
  std::string type;
  int parent = -1;
  int child = -1;
  Eigen::Matrix4d parent_from_joint;  // X_PF
  Eigen::Matrix4d child_from_joint;   // X_BM
  std::array<TransformAxis, 3> rotations, translations;
  bool is_reversed = false;  // axes take the parent to the child
  // Why its motion is not known ("GCVSpline in axis rotation1, line 12"); ""
  // if it is.
  std::string unsupported;
};

// A mesh attached to a body. Its points, scaled, are those of the body's frame
// after body_from_mesh (mm).
struct ModelGeometry {
  std::string file;  // as the model names it, slashes forward
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Matrix4d body_from_mesh = Eigen::Matrix4d::Identity();
};

struct Body {
  std::string name;
  // The joint whose child it is; -1 for the ground, or if there is none.
  int joint = -1;
  std::vector<ModelGeometry> geometry;
};

// A point of a muscle's path. Fixed, unless it moves; there all the time,
// unless it has a condition.
struct PathPoint {
  std::string name;
  int body = -1;
  Eigen::Vector3d location = Eigen::Vector3d::Zero();  // in the body, mm
  // A moving point: functions of a coordinate each, mm, in a frame of the body.
  bool is_moving = false;
  std::array<int, 3> moving_coordinates = {-1, -1, -1};  // -1: a constant
  std::array<FunctionPtr, 3> moving_functions;
  Eigen::Matrix4d body_from_frame = Eigen::Matrix4d::Identity();
  // A conditional point: there while the coordinate is in the range.
  int condition = -1;  // coordinate; -1: no condition
  double range[2] = {0, 0};
};

struct ModelMuscle {
  std::string name;
  std::vector<PathPoint> path;
  std::string unsupported;  // as for joints
};

struct Model {
  std::string path;  // of the file
  std::string name;
  std::vector<Body> bodies;  // the ground first
  std::vector<Joint> joints;
  std::vector<Coordinate> coordinates;
  std::vector<CoordinateCoupler> couplers;
  std::vector<ModelMuscle> muscles;
  // What the file has and this project does not follow, each once.
  std::vector<std::string> warnings;

  // Index by name, -1 if there is none.
  int FindBody(const std::string& body) const;
  int FindCoordinate(const std::string& coordinate) const;
  int FindMuscle(const std::string& muscle) const;
};

// Reads a model of OpenSim 2 to 4 (.osim). Throws InputError with file, line
// and element: not XML or cut short, an element missing or not a number, a name
// that nothing has, bodies whose joints go round in a circle. Joints and
// functions that are not supported are an error only where they are needed
// (kinematics.h).
Model ReadModel(const std::string& path);

}  // namespace musclewarp
