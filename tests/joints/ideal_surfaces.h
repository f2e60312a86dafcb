// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>

#include "musclewarp/joints/cylinder_fit.h"
#include "musclewarp/joints/surface_points.h"
#include "support/meshes.h"

namespace musclewarp {

// Points that lie on surfaces exactly, with exact normals, spread at random.

// The angle between two lines, whichever way they point, rad; precise for small
// angles too.
inline double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

// A rotation by any angle and a translation by up to 200 mm along each axis.
inline Eigen::Isometry3d RandomMotion(std::uint32_t seed) {
  const Points random = RandomPoints(3, seed);
  const Eigen::Vector4d turn(
      random(0, 0), random(0, 1), random(0, 2), random(1, 0));
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() =
      Eigen::Quaterniond(Eigen::Vector4d(turn.normalized())).toRotationMatrix();
  motion.translation() = 200 * random.row(2).transpose();
  return motion;
}

inline SurfacePoints MovedBy(const Eigen::Isometry3d& motion,
                             SurfacePoints surface) {
  surface.points = (surface.points * motion.linear().transpose()).rowwise() +
                   motion.translation().transpose();
  surface.normals *= motion.linear().transpose();
  return surface;
}

inline Axis MovedBy(const Eigen::Isometry3d& motion, const Axis& axis) {
  return {motion * axis.point, motion.linear() * axis.direction};
}

inline SurfacePoints IdealSphere(const Eigen::Vector3d& center,
                                 double radius,
                                 int count) {
  SurfacePoints sphere;
  sphere.normals.resize(count, 3);
  for (int i = 0; i < count; ++i) {
    // Evenly, along a spiral.
    constexpr double kGoldenAngle = 2.399963229728653;
    const double z = 1 - (2 * i + 1.0) / count;
    const double across = std::sqrt(1 - z * z);
    sphere.normals.row(i) << across * std::cos(i * kGoldenAngle),
        across * std::sin(i * kGoldenAngle), z;
  }
  sphere.points =
      (radius * sphere.normals).rowwise() + Eigen::RowVector3d(center);
  sphere.area = 4 * M_PI * radius * radius / count;
  return sphere;
}

// The part of a cylinder about z with heights in [-length / 2, length / 2] and
// angles in [-angle / 2, angle / 2] about the x axis.
inline SurfacePoints IdealCylinder(double radius,
                                   double length,
                                   double angle,
                                   int count) {
  const Points random = RandomPoints(count, 1);
  SurfacePoints cylinder;
  cylinder.points.resize(count, 3);
  cylinder.normals.resize(count, 3);
  for (int i = 0; i < count; ++i) {
    const double turn = random(i, 0) * angle / 2;
    cylinder.normals.row(i) << std::cos(turn), std::sin(turn), 0;
    cylinder.points.row(i) = radius * cylinder.normals.row(i);
    cylinder.points(i, 2) = random(i, 1) * length / 2;
  }
  cylinder.area = radius * angle * length / count;
  return cylinder;
}

// A torus about z; `angle` as above.
inline SurfacePoints IdealTorus(double large_radius,
                                double small_radius,
                                double angle,
                                int count) {
  const Points random = RandomPoints(count, 2);
  SurfacePoints torus;
  torus.points.resize(count, 3);
  torus.normals.resize(count, 3);
  for (int i = 0; i < count; ++i) {
    const double turn = random(i, 0) * angle / 2;
    const double around = random(i, 1) * M_PI;
    const Eigen::RowVector3d out(std::cos(turn), std::sin(turn), 0);
    torus.normals.row(i) = std::cos(around) * out;
    torus.normals(i, 2) = std::sin(around);
    torus.points.row(i) =
        large_radius * out + small_radius * torus.normals.row(i);
  }
  torus.area = 2 * M_PI * small_radius * angle * large_radius / count;
  return torus;
}

// An ellipsoid of revolution about z.
inline SurfacePoints IdealEllipsoid(double across, double along, int count) {
  SurfacePoints ellipsoid = IdealSphere({0, 0, 0}, 1, count);
  const Eigen::RowVector3d axes(across, across, along);
  ellipsoid.points.array().rowwise() *= axes.array();
  ellipsoid.normals.array().rowwise() /= axes.array();
  ellipsoid.normals.rowwise().normalize();
  return ellipsoid;
}

}  // namespace musclewarp
