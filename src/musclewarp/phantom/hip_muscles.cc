// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/phantom/curves.h"
#include "musclewarp/phantom/hip_solids.h"

namespace musclewarp::phantom {
namespace {

// A fan spread over the iliac wing and gathered on the trochanter, between two
// surfaces x(y, z) inside an outline in the (y, z) plane.
struct Fan {
  std::vector<Eigen::Vector2d> outline;
  Eigen::Vector2d insertion;  // (y, z)
  double insertion_x;         // of the tendon's outer face
  double length;              // from the insertion to the middle of the origin
  double tendon_fraction;     // of the length: stays on the trochanter
  double origin_thickness;    // above the wing
  double bulge;               // of the belly, outward
  double tendon_thickness;
  double belly_thickness;
};

// The x of both faces at (y, z).
struct Faces {
  double inner;
  double outer;
};

Faces FacesAt(const Fan& fan, double y, double z) {
  constexpr double kPi = 3.14159265358979323846;
  const double t = std::min(
      (Eigen::Vector2d(y, z) - fan.insertion).norm() / fan.length, 1.0);
  const double wing = WingLateralX(y, z);
  // The outer face leaves the trochanter and lies down on the wing.
  const double off = std::min(
      SmoothMax(0, (t - fan.tendon_fraction) / (1 - fan.tendon_fraction), 0.1),
      1.0);
  const double to_wing = 1 - (1 - off) * std::sqrt(1 - off);
  Faces faces;
  faces.outer = (1 - to_wing) * fan.insertion_x +
                to_wing * (wing + fan.origin_thickness) +
                fan.bulge * std::sin(kPi * t);
  const double thickness =
      fan.tendon_thickness +
      (fan.belly_thickness - fan.tendon_thickness) * SmoothStep(0.1, 0.55, t);
  const double on_wing = SmoothStep(0.35, 0.65, t);
  faces.inner = (1 - on_wing) * (faces.outer - thickness) +
                on_wing * (wing - kAttachmentDepth);
  return faces;
}

Field FanField(const Fan& fan) {
  const Outline outline(fan.outline);
  return [fan, outline](const Eigen::Vector3d& p) {
    const Faces faces = FacesAt(fan, p.y(), p.z());
    // The faces are steep: x(y, z) has a slope of about 45 degrees.
    constexpr double kAcross = 0.75;
    const double middle = 0.5 * (faces.inner + faces.outer);
    const double half = 0.5 * (faces.outer - faces.inner);
    const double across = kAcross * (std::abs(p.x() - middle) - half);
    return SmoothMax(across, outline.SignedDistance({p.y(), p.z()}), 9);
  };
}

// Returns `muscle` cut along a neighbour, so that it is at most `depth` inside.
Field LyingOn(Field muscle, Field neighbour, double depth) {
  return Difference(muscle, Offset(neighbour, -depth), 4);
}

}  // namespace

Field GluteusMinimusField(const Field& bones) {
  Fan fan;
  fan.outline = {{2, -34},
                 {12, -22},
                 {17, -4},
                 {25, 18},
                 {33, 42},
                 {33, 66},
                 {18, 86},
                 {-10, 94},
                 {-38, 86},
                 {-54, 66},
                 {-44, 42},
                 {-28, 16},
                 {-13, -8},
                 {-8, -24}};
  fan.insertion = {2, -22};
  fan.insertion_x = 72;
  fan.length = 112;
  fan.tendon_fraction = 0.06;
  fan.origin_thickness = 8;
  fan.bulge = 6;
  fan.tendon_thickness = 12;
  fan.belly_thickness = 18;
  return LyingOn(FanField(fan), bones, kAttachmentDepth);
}

Field GluteusMediusField(const Field& bones, const Field& gluteus_minimus) {
  Fan fan;
  fan.outline = {{-14, -46},
                 {-3, -34},
                 {3, -14},
                 {12, 10},
                 {26, 40},
                 {38, 72},
                 {31, 98},
                 {6, 114},
                 {-26, 120},
                 {-56, 114},
                 {-80, 97},
                 {-88, 78},
                 {-70, 54},
                 {-50, 24},
                 {-34, -6},
                 {-26, -30}};
  fan.insertion = {-13, -30};
  fan.insertion_x = 80;
  fan.length = 148;
  fan.tendon_fraction = 0.13;
  fan.origin_thickness = 9;
  fan.bulge = 8;
  fan.tendon_thickness = 12;
  fan.belly_thickness = 24;
  // The small muscle and the bone are joined smoothly, so that no wedge is left
  // between them.
  const Field bed = Union(Offset(gluteus_minimus, -kSheetOverlap),
                          Offset(bones, -kAttachmentDepth),
                          12);
  return LyingOn(FanField(fan), bed, 0);
}

Field PsoasField(const Field& bones) {
  const Field strap = Sweep({{{-50, -8, 205}, 7},
                             {{-52, -6, 185}, 11},
                             {{-53, 0, 145}, 16},
                             {{-48, 12, 95}, 18},
                             {{-34, 30, 50}, 16.5},
                             {{-17, 42, 18}, 13.5},
                             {{0, 38, -16}, 11.5},
                             {{17, 12, -46}, 9.5},
                             {{26, -12, -66}, 8},
                             {{29, -19, -74}, 7}});
  return Difference(strap, Offset(bones, -kAttachmentDepth), 7);
}

}  // namespace musclewarp::phantom
