// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "joints/ideal_surfaces.h"
#include "musclewarp/base/angles.h"
#include "musclewarp/joints/limb.h"
#include "musclewarp/joints/sphere_fit.h"

namespace musclewarp {

// Femora as they were measured, and surfaces of which bones are made, in the
// axes LPS: x to the left of the body, y to the back, z up, mm.

// Right, up and forward of the body, in the columns of the axes of an image.
inline Eigen::Matrix3d AxesOfLps() {
  Eigen::Matrix3d axes;
  axes << 0, 0, -1, -1, 0, 0, 0, 1, 0;
  return axes;
}

// A right femur with the knee at the origin, whose measures are those of the
// persons of benchmarks/joint_accuracy.md: nothing of it is weak.
inline FemurShape SoundFemur() {
  FemurShape femur;
  SphereFit head;
  head.sphere = {{40, 0, 400}, 23};
  head.coverage = 0.6;
  head.spread = 0.45;
  femur.head = head;
  femur.best_coverage = head.coverage;
  BoneDirections directions;
  directions.up = Eigen::Vector3d::UnitZ();
  directions.back = Eigen::Vector3d::UnitY();
  directions.left = Eigen::Vector3d::UnitX();
  directions.back_to_front = 2;
  directions.lowest = -20;
  femur.directions = directions;
  KneeFit knee;
  knee.cylinder = {{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX()}, 20};
  knee.left_angle = knee.right_angle = RadiansOf(120);
  knee.spread = 0.7;
  knee.sphere_angle = RadiansOf(1);
  femur.knee = knee;
  return femur;
}

// The part of a sphere within an angle (rad) of a direction, with outward
// normals. Of a whole sphere it would be `count` points.
inline SurfacePoints IdealCap(const Sphere& sphere,
                              const Eigen::Vector3d& direction,
                              double angle,
                              int count) {
  const SurfacePoints whole = IdealSphere(sphere.center, sphere.radius, count);
  return Filtered(whole, [&](int row) {
    return whole.normals.row(row).dot(direction.normalized()) >=
           std::cos(angle);
  });
}

// The same surface as the wall of a hollow.
inline SurfacePoints Hollow(SurfacePoints surface) {
  surface.normals *= -1;
  return surface;
}

// Two surfaces of one bone.
inline SurfacePoints Together(const SurfacePoints& a, const SurfacePoints& b) {
  SurfacePoints both;
  both.points.resize(a.size() + b.size(), 3);
  both.points << a.points, b.points;
  both.normals.resize(a.size() + b.size(), 3);
  both.normals << a.normals, b.normals;
  both.area = std::max(a.area, b.area);
  return both;
}

// Points from one place to another, whose normals mean nothing.
inline SurfacePoints PointsBetween(const Eigen::Vector3d& from,
                                   const Eigen::Vector3d& to,
                                   int count = 101) {
  SurfacePoints line;
  line.points.resize(count, 3);
  line.normals.resize(count, 3);
  for (int i = 0; i < count; ++i) {
    line.points.row(i) = (from + (to - from) * i / (count - 1)).transpose();
    line.normals.row(i) << 1, 0, 0;
  }
  line.area = 1;
  return line;
}

}  // namespace musclewarp
