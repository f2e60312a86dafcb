// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/joint_building.h"

#include <Eigen/Geometry>

namespace musclewarp {

FoundJoint StartedJoint(JointKind kind, const Limb& limb) {
  FoundJoint joint;
  joint.kind = kind;
  joint.side = limb.side;
  joint.parent = ParentBody(kind, limb.side);
  joint.child = ChildBody(kind, limb.side);
  return joint;
}

FittedShape ShapeOf(const std::string& what, const SphereFit& fit) {
  FittedShape shape;
  shape.what = what;
  shape.kind = FittedShape::Kind::kSphere;
  shape.center = fit.sphere.center;
  shape.radius = fit.sphere.radius;
  shape.spread = fit.spread;
  shape.coverage = fit.coverage;
  return shape;
}

FittedShape ShapeOf(const std::string& what,
                    const Cylinder& cylinder,
                    double spread,
                    double angle) {
  FittedShape shape;
  shape.what = what;
  shape.kind = FittedShape::Kind::kCylinder;
  shape.center = cylinder.axis.point;
  shape.direction = cylinder.axis.direction;
  shape.radius = cylinder.radius;
  shape.spread = spread;
  shape.angle = angle;
  return shape;
}

Eigen::Matrix3d AxesAlong(int exact,
                          const Eigen::Vector3d& exact_axis,
                          int near,
                          const Eigen::Vector3d& near_axis) {
  Eigen::Matrix3d axes;
  axes.col(exact) = exact_axis.normalized();
  axes.col(near) =
      (near_axis - near_axis.dot(axes.col(exact)) * axes.col(exact))
          .normalized();
  const int last = 3 - exact - near;
  axes.col(last) = axes.col((last + 1) % 3).cross(axes.col((last + 2) % 3));
  return axes;
}

}  // namespace musclewarp
