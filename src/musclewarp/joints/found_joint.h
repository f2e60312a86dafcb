// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "musclewarp/joints/joint_table.h"

namespace musclewarp {

// How far a joint is to be trusted.
enum class JointQuality {
  kGood,
  kWeak,    // used, and named wherever it is shown
  kFailed,  // not found: its child bone stays fixed to its parent
};

// "good", "weak", "failed".
std::string ToString(JointQuality quality);

// A verdict and what it rests on. It only ever gets worse.
struct JointVerdict {
  JointQuality quality = JointQuality::kGood;
  std::vector<std::string> reasons;  // one sentence each, without a full stop

  void Weaken(const std::string& reason);
  void Fail(const std::string& reason);
};

// A shape that was fitted to a bone.
struct FittedShape {
  enum class Kind { kSphere, kCylinder, kAxis };
  std::string what;  // "head of the femur"
  Kind kind = Kind::kSphere;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();     // mm
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // of the axis; or zero
  double radius = 0;          // mm; 0 for an axis alone
  double spread = 0;          // root mean square distance of the points, mm
  double coverage = 0;        // of a sphere, as a share
  double angle = 0;           // covered about an axis, rad
  bool is_on_parent = false;  // of the joint; else on the child
};

// How the only coordinate of a joint follows one of another joint: it is
// linear between points, and constant beyond them.
struct JointCoupling {
  std::string coordinate;      // that is followed; empty: none
  std::vector<double> at;      // its values, rad, ascending
  std::vector<double> values;  // of the coordinate that follows, rad
};

// A joint as it is on the bones of one person, in the frame of the image.
struct FoundJoint {
  JointKind kind = JointKind::kHip;
  Side side = Side::kRight;
  std::string parent, child;  // bodies

  // Its place, mm, and the axes of its frames on both bodies in the pose of the
  // scan: columns are x forward, y up, z to the right. Coordinates are 0 where
  // both frames are parallel.
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Matrix3d parent_axes = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d child_axes = Eigen::Matrix3d::Identity();

  JointCoupling coupling;

  JointVerdict verdict;
  bool is_given = false;  // by the user
  std::vector<FittedShape> shapes;

  std::string name() const { return JointName(kind, side); }
  bool IsFound() const { return verdict.quality != JointQuality::kFailed; }
};

// Returns the values of the coordinates of a joint in the pose of the scan,
// rad: the turns about their axes, one after the other, that take the frame of
// the parent to that of the child. For a hinge it is the turn about its axis.
std::vector<double> ScanCoordinates(const FoundJoint& joint);

}  // namespace musclewarp
