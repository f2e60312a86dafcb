// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

namespace musclewarp::phantom {

// Points on the Catmull-Rom curve through `controls`, the controls among them:
// `samples` steps per span. Open curves double their end controls. At least two
// controls, three if closed; a closed curve does not repeat its first point.
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

// A region of the plane bounded by the closed Catmull-Rom curve through
// `controls` (either direction, not self-intersecting).
class Outline {
 public:
  explicit Outline(const std::vector<Eigen::Vector2d>& controls);

  // Distance to the boundary, mm, negative inside.
  double SignedDistance(const Eigen::Vector2d& p) const;

 private:
  // A part of the boundary, boxed so that most parts need no look.
  struct Span {
    std::vector<Eigen::Vector2d> points;
    Eigen::AlignedBox2d box;
  };
  std::vector<Span> spans_;
};

}  // namespace musclewarp::phantom
