// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/curves.h"

#include <glog/logging.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace musclewarp::phantom {
namespace {

constexpr int kSamplesPerOutlineSpan = 4;

}  // namespace

Outline::Outline(const std::vector<Eigen::Vector2d>& controls) {
  CHECK_GE(controls.size(), 3u);
  std::vector<Eigen::Vector2d> curve =
      SampleCatmullRom(controls, kSamplesPerOutlineSpan, true);
  curve.push_back(curve.front());
  for (size_t first = 0; first + 1 < curve.size();
       first += kSamplesPerOutlineSpan) {
    Span span;
    span.points.assign(curve.begin() + first,
                       curve.begin() + first + kSamplesPerOutlineSpan + 1);
    for (const Eigen::Vector2d& p : span.points) span.box.extend(p);
    spans_.push_back(span);
  }
}

double Outline::SignedDistance(const Eigen::Vector2d& p) const {
  double squared = std::numeric_limits<double>::infinity();
  bool is_inside = false;
  for (const Span& span : spans_) {
    const bool is_beside =
        p.y() < span.box.min().y() || p.y() > span.box.max().y();
    if (is_beside && span.box.squaredExteriorDistance(p) >= squared) continue;
    for (size_t i = 0; i + 1 < span.points.size(); ++i) {
      const Eigen::Vector2d& a = span.points[i];
      const Eigen::Vector2d& b = span.points[i + 1];
      const Eigen::Vector2d ab = b - a;
      const Eigen::Vector2d ap = p - a;
      const double t = std::clamp(ap.dot(ab) / ab.squaredNorm(), 0.0, 1.0);
      squared = std::min(squared, (ap - t * ab).squaredNorm());
      // Even-odd rule: a ray along the first axis crosses this edge.
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          ap.x() < ap.y() * ab.x() / ab.y()) {
        is_inside = !is_inside;
      }
    }
  }
  return is_inside ? -std::sqrt(squared) : std::sqrt(squared);
}

}  // namespace musclewarp::phantom
