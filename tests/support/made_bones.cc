// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "support/made_bones.h"

#include <cmath>

#include "musclewarp/base/angles.h"
#include "musclewarp/phantom/field.h"
#include "musclewarp/phantom/polygonize.h"

namespace musclewarp {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using phantom::Difference;
using phantom::Ellipsoid;
using phantom::Field;
using phantom::SmoothMax;
using phantom::Sweep;
using phantom::Union;

// A cylinder along x.
Field CylinderAlongX(double middle,
                     double half_length,
                     double radius,
                     double rounding) {
  return [=](const Vector3d& p) {
    return SmoothMax(std::hypot(p.y(), p.z()) - radius,
                     std::abs(p.x() - middle) - half_length,
                     rounding);
  };
}

Field Block(const Vector3d& middle, const Vector3d& half, double rounding) {
  return [=](const Vector3d& p) {
    const Vector3d beyond = (p - middle).cwiseAbs() - half;
    return SmoothMax(
        SmoothMax(beyond.x(), beyond.y(), rounding), beyond.z(), rounding);
  };
}

// The solid turned by a rotation about the origin.
Field Turned(const Matrix3d& rotation, const Field& field) {
  return [=](const Vector3d& p) { return field(rotation.transpose() * p); };
}

TriangleSoup MeshOf(const Field& field,
                    const Vector3d& lower,
                    const Vector3d& upper,
                    double cell) {
  phantom::PolygonizeOptions options;
  options.cell = cell;
  return PolygonizeField(field, {lower, upper}, options);
}

// The frame of a joint whose axis is turned about z and then leans upwards: its
// columns are the axis, back and up.
Matrix3d JointFrame(double turn, double lean) {
  return (Eigen::AngleAxisd(turn, Vector3d::UnitZ()) *
          Eigen::AngleAxisd(-lean, Vector3d::UnitY()))
      .toRotationMatrix();
}

constexpr double kKneeTurn = 2 * kRadiansPerDegree;
constexpr double kKneeLean = 3 * kRadiansPerDegree;

// The part of a femur at the knee, with the axis along x.
Field Condyles() {
  constexpr double kHalfNotch = 7.5, kHalfLength = 15, kRounding = 4;
  const auto condyle = [=](double side) {
    return CylinderAlongX(side * (kHalfNotch + kHalfLength),
                          kHalfLength,
                          kMadeCondyleRadius,
                          kRounding);
  };
  // In front of the notch, which the kneecap glides on.
  const Field front = Ellipsoid({0, -14, 2}, {32, 17, 17});
  return Union(Union(condyle(-1), condyle(1), 0), front, 4);
}

}  // namespace

MadeFemur RightFemur(double cell) {
  MadeFemur femur;
  femur.head = {48, -18, 395};
  const Matrix3d knee = JointFrame(kKneeTurn, kKneeLean);
  femur.knee = {Vector3d::Zero(), knee.col(0)};
  femur.up = Vector3d::UnitZ();
  femur.back = knee.col(1);
  femur.left = femur.back.cross(femur.up);
  // The condyles reach farther back from the line of the shaft than the rest of
  // the lower end reaches forward.
  const Field shaft = Sweep({{{0, -14, 340}, 15},
                             {{0, -14, 250}, 13.5},
                             {{0, -14, 150}, 13.5},
                             {{0, -14, 70}, 15},
                             {{0, -14, 25}, 20}});
  const Field neck =
      Sweep({{{0, -14, 340}, 16}, {{24, -16, 370}, 14}, {femur.head, 14}});
  const Field trochanter = Ellipsoid({-20, -10, 342}, {14, 18, 24});
  const Field upper = Union(Union(shaft, trochanter, 10), neck, 10);
  const Field with_head =
      Union(upper, phantom::Sphere(femur.head, kMadeHeadRadius), 4);
  femur.surface = MeshOf(Union(with_head, Turned(knee, Condyles()), 6),
                         {-55, -50, -40},
                         {85, 40, 435},
                         cell);
  return femur;
}

MadeFemur Mirrored(const MadeFemur& femur) {
  const Eigen::DiagonalMatrix<double, 3> mirror(-1, 1, 1);
  MadeFemur image = femur;
  image.surface.points = femur.surface.points * mirror;
  image.surface.triangles.col(1).swap(image.surface.triangles.col(2));
  image.head = mirror * femur.head;
  image.knee.point = mirror * femur.knee.point;
  // What pointed to the left points to the right.
  image.knee.direction = -(mirror * femur.knee.direction);
  image.up = mirror * femur.up;
  image.back = mirror * femur.back;
  image.left = -(mirror * femur.left);
  return image;
}

BoneDirections DirectionsOf(const MadeFemur& femur,
                            const SurfacePoints& points) {
  return DirectionsOfFemur(points, ShaftOf(points, femur.up), kMadeHeadRadius);
}

MadeFemur MovedBy(const Eigen::Isometry3d& motion, const MadeFemur& femur) {
  MadeFemur moved = femur;
  moved.surface.points =
      (femur.surface.points * motion.linear().transpose()).rowwise() +
      motion.translation().transpose();
  moved.head = motion * femur.head;
  moved.knee = {motion * femur.knee.point,
                motion.linear() * femur.knee.direction};
  moved.up = motion.linear() * femur.up;
  moved.back = motion.linear() * femur.back;
  moved.left = motion.linear() * femur.left;
  return moved;
}

MadeAnkle RightAnkle(double gap, double cell) {
  constexpr double kHalfWidth = 14;
  const Matrix3d frame =
      JointFrame(-12 * kRadiansPerDegree, 8 * kRadiansPerDegree);
  MadeAnkle ankle;
  ankle.axis = {Vector3d::Zero(), frame.col(0)};
  const Field dome = CylinderAlongX(0, kHalfWidth, kMadeDomeRadius, 3);
  const Field body = Union(Ellipsoid({0, 2, -16}, {15, 24, 10}),
                           Sweep({{{0, -12, -13}, 9}, {{4, -38, -15}, 12}}),
                           6);
  ankle.talus = MeshOf(
      Turned(frame, Union(dome, body, 4)), {-40, -65, -45}, {40, 45, 40}, cell);
  const Field solid = Union(Block({0, 0, 35}, {24, 20, 25}, 4),
                            Block({22, 0, 14}, {5, 11, 20}, 4),
                            3);
  const Field hollow =
      CylinderAlongX(0, kHalfWidth + gap, kMadeDomeRadius + gap, 3);
  ankle.tibia = MeshOf(Turned(frame, Difference(solid, hollow, 3)),
                       {-55, -45, -25},
                       {55, 45, 80},
                       cell);
  return ankle;
}

MadeSocket BlockWithSocket(double cell) {
  MadeSocket socket;
  socket.center = {3, -2, -4};
  socket.surface =
      MeshOf(Difference(Block({0, 0, 30}, {42, 42, 30}, 4),
                        phantom::Sphere(socket.center, kMadeSocketRadius),
                        3),
             {-50, -50, -10},
             {50, 50, 70},
             cell);
  return socket;
}

}  // namespace musclewarp
