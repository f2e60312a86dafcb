// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "musclewarp/phantom/curves.h"
#include "musclewarp/phantom/hip_solids.h"

namespace musclewarp::phantom {
namespace {

constexpr double kWingThickness = 7;

// The middle surface of the iliac wing, x over (y, z): flared to the side
// above, turned inward behind.
double WingMiddleX(double y, double z) {
  return -15 + 0.36 * (z - 20) + 0.40 * y - 0.0020 * y * y -
         0.0012 * (z - 60) * (z - 60);
}

// Returns how much longer the path along x is than the path straight through
// the plate.
double WingSlant(double y, double z) {
  const double dy = 0.40 - 0.0040 * y;
  const double dz = 0.36 - 0.0024 * (z - 60);
  return std::sqrt(1 + dy * dy + dz * dz);
}

Eigen::Vector3d OnWing(double y, double z) { return {WingMiddleX(y, z), y, z}; }

Field Wing() {
  const Outline outline({{45, 80},
                         {34, 106},
                         {6, 125},
                         {-26, 132},
                         {-58, 125},
                         {-86, 106},
                         {-102, 82},
                         {-94, 56},
                         {-68, 44},
                         {-50, 26},
                         {-44, 2},
                         {-30, -10},
                         {8, -8},
                         {26, 10},
                         {36, 34},
                         {37, 56}});
  const Field plate = [outline](const Eigen::Vector3d& p) {
    const double y = p.y();
    const double z = p.z();
    const double across =
        std::abs(p.x() - WingMiddleX(y, z)) / WingSlant(y, z) -
        kWingThickness / 2;
    return SmoothMax(across, outline.SignedDistance({y, z}), 5);
  };
  // The wing is thick where a real one is: at its rim, with the spines in front
  // and behind, and at the joint with the sacrum.
  const Field crest = Sweep({{OnWing(14, 8), 5},
                             {OnWing(28, 20), 6},
                             {OnWing(33, 38), 7},
                             {OnWing(33, 56), 4.5},
                             {OnWing(41, 79), 6.5},
                             {OnWing(32, 103), 5},
                             {OnWing(5, 121), 6},
                             {OnWing(-26, 128), 5},
                             {OnWing(-57, 121), 5},
                             {OnWing(-84, 102), 7},
                             {OnWing(-97, 82), 8},
                             {OnWing(-89, 62), 7},
                             {OnWing(-67, 49), 5},
                             {OnWing(-48, 32), 5},
                             {OnWing(-38, 8), 6},
                             {OnWing(-34, -2), 7},
                             {OnWing(-20, -6), 6},
                             {OnWing(-2, -4), 6}});
  const Field sacral = Ellipsoid(OnWing(-74, 68), {9, 22, 20});
  return Union(Union(plate, crest, 6), sacral, 10);
}

// Ischium below and behind, pubis in front, their branches around the hole.
Field LowerPelvis() {
  const Field ischium = Sweep({{{-12, -22, -4}, 19},
                               {{-13, -36, -30}, 15},
                               {{-14, -42, -56}, 16},
                               {{-22, -34, -72}, 12}});
  const Field upper_branch = Sweep({{{-14, 16, 8}, 17},
                                    {{-32, 32, 4}, 11},
                                    {{-54, 42, -10}, 9.5},
                                    {{-70, 44, -22}, 11}});
  const Field symphysis = Sweep({{{-73, 42, -22}, 10}, {{-72, 34, -46}, 9}});
  const Field lower_branch = Sweep({{{-70, 32, -48}, 8},
                                    {{-54, 10, -64}, 6.5},
                                    {{-36, -18, -74}, 7.5},
                                    {{-22, -34, -70}, 11}});
  return Union(
      Union(ischium, upper_branch, 12), Union(symphysis, lower_branch, 8), 8);
}

}  // namespace

double WingLateralX(double y, double z) {
  return WingMiddleX(y, z) + kWingThickness / 2 * WingSlant(y, z);
}

Field PelvisField() {
  // The cup faces to the side, forward and down.
  const Eigen::Vector3d opening(0.76, 0.34, -0.55);
  const Field cup =
      Intersection(Sphere({0, 0, 0}, 36.5), HalfSpace(opening, 6), 6);
  const Field solid = Union(Union(Wing(), LowerPelvis(), 14), cup, 10);
  return Difference(solid, Sphere({0, 0, 0}, kSocketRadius), 6);
}

Field FemurField() {
  const Field head = Sphere({0, 0, 0}, kHeadRadius);
  const Field neck = Sweep({{{8, -1, -7}, 15},
                            {{24, -3, -20}, 14.5},
                            {{40, -7, -33}, 17.5},
                            {{50, -10, -46}, 19}});
  const Field greater_trochanter =
      Union(Ellipsoid({58, -13, -26}, {13, 18, 22}),
            Ellipsoid({53, -20, -9}, {9, 12, 14}),
            10);
  const Field lesser_trochanter = Ellipsoid({31, -24, -74}, {10, 10, 14});
  const Field shaft = Sweep({{{50, -10, -44}, 19},
                             {{46, -9, -70}, 18.5},
                             {{42, -6, -105}, 15.5},
                             {{35, -1, -160}, 14},
                             {{27, 2, -220}, 13.5},
                             {{19, 2, -280}, 14}});
  const Field shaft_with_bumps =
      Union(Union(shaft, greater_trochanter, 10), lesser_trochanter, 10);
  const Field femur = Union(Union(neck, shaft_with_bumps, 12), head, 6);
  // The shaft is cut as if the scan ended there.
  return Intersection(femur, HalfSpace({0, 0, -1}, 235), 4);
}

}  // namespace musclewarp::phantom
