// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace musclewarp::phantom {

// Returns points on the Catmull-Rom curve through `controls`: the controls
// themselves, and between neighbours samples - 1 points at equal parameters.
// The curve interpolates its controls and has a continuous tangent, which at a
// control is parallel to the line between the two beside it. An open curve
// takes its first and last control twice; a closed one does not repeat its
// first point at the end. Preconditions: two controls or more, three if closed;
// samples >= 1.
template <typename Vector>
std::vector<Vector> SampleCatmullRom(const std::vector<Vector>& controls,
                                     int samples,
                                     bool is_closed) {
  const int count = controls.size();
  const auto control = [&](int i) -> const Vector& {
    return is_closed ? controls[(i + count) % count]
                     : controls[std::min(std::max(i, 0), count - 1)];
  };
  std::vector<Vector> curve;
  for (int i = 0; i < (is_closed ? count : count - 1); ++i) {
    const Vector& a = control(i - 1);
    const Vector& b = control(i);
    const Vector& c = control(i + 1);
    const Vector& d = control(i + 2);
    for (int k = 0; k < samples; ++k) {
      const double t = static_cast<double>(k) / samples;
      curve.push_back(b + 0.5 * t *
                              (c - a +
                               t * (2 * a - 5 * b + 4 * c - d +
                                    t * (3 * (b - c) + d - a))));
    }
  }
  if (!is_closed) curve.push_back(controls.back());
  return curve;
}

// A region of the plane, such as the silhouette of a bone, given by points on
// its boundary: the boundary is the closed Catmull-Rom curve through them, as a
// polygon of four edges per span.
class Outline {
 public:
  // The controls may run in either direction. Preconditions: there are at least
  // three (CHECKed), and the curve does not cross itself.
  explicit Outline(const std::vector<Eigen::Vector2d>& controls);

  // Returns the distance of p to the boundary, mm, negative inside.
  double SignedDistance(const Eigen::Vector2d& p) const;

 private:
  // The edges between two controls, in a box so that most of them need not be
  // looked at.
  struct Span {
    std::vector<Eigen::Vector2d> points;
    Eigen::AlignedBox2d box;
  };
  std::vector<Span> spans_;
};

}  // namespace musclewarp::phantom
