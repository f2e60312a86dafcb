// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/field.h"

#include <glog/logging.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "musclewarp/phantom/curves.h"

namespace musclewarp::phantom {
namespace {

constexpr int kSamplesPerSweepSpan = 5;

// At larger distances from a part of a shape, mm, a lower bound of the distance
// is sufficient, because no smooth operator reaches that far.
constexpr double kFarFromSweep = 16;

// Mixes the bits of a lattice point and a seed (constants of the 32-bit
// finalizer of MurmurHash3, public domain).
uint32_t Hash(int x, int y, int z, uint32_t seed) {
  uint32_t h = seed;
  for (const int word : {x, y, z}) {
    h ^= static_cast<uint32_t>(word) * 0x9e3779b1u;
    h ^= h >> 16;
    h *= 0x85ebca6bu;
    h ^= h >> 13;
    h *= 0xc2b2ae35u;
    h ^= h >> 16;
  }
  return h;
}

// Random values in [-1, 1] at the points of the unit lattice, between them
// trilinear with smooth weights.
double ValueNoise(const Eigen::Vector3d& p, uint32_t seed) {
  const Eigen::Vector3d floor = p.array().floor();
  const Eigen::Vector3i cell = floor.cast<int>();
  Eigen::Vector3d weight = p - floor;
  weight = weight.array().square() * (3 - 2 * weight.array());
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double product = 1;
    Eigen::Vector3i at = cell;
    for (int axis = 0; axis < 3; ++axis) {
      const bool is_upper = (corner >> axis) & 1;
      at[axis] += is_upper;
      product *= is_upper ? weight[axis] : 1 - weight[axis];
    }
    sum += product * (Hash(at[0], at[1], at[2], seed) / 2147483647.5 - 1);
  }
  return sum;
}

// A part of a sweep: nodes are centre and radius.
struct SweepSpan {
  std::vector<Eigen::Vector4d> nodes;
  Eigen::AlignedBox3d centres;
  double largest_radius = 0;
};

double DistanceToSweepSpan(const SweepSpan& span, const Eigen::Vector3d& p) {
  double distance = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i + 1 < span.nodes.size(); ++i) {
    const Eigen::Vector4d step = span.nodes[i + 1] - span.nodes[i];
    const Eigen::Vector3d from_start = p - span.nodes[i].head<3>();
    const double t = std::clamp(
        from_start.dot(step.head<3>()) / step.head<3>().squaredNorm(),
        0.0,
        1.0);
    distance = std::min(distance,
                        (from_start - t * step.head<3>()).norm() -
                            (span.nodes[i][3] + t * step[3]));
  }
  return distance;
}

}  // namespace

double SmoothMin(double a, double b, double width) {
  const double h = std::max(width - std::abs(a - b), 0.0);
  return std::min(a, b) - (width > 0 ? h * h / (4 * width) : 0);
}

double SmoothMax(double a, double b, double width) {
  return -SmoothMin(-a, -b, width);
}

double SmoothStep(double low, double high, double value) {
  const double t = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Field Sphere(const Eigen::Vector3d& centre, double radius) {
  return [=](const Eigen::Vector3d& p) { return (p - centre).norm() - radius; };
}

Field Ellipsoid(const Eigen::Vector3d& centre, const Eigen::Vector3d& radii) {
  return [=](const Eigen::Vector3d& p) {
    // First-order distance: k0 (k0 - 1) / |gradient of k0^2 / 2|.
    const Eigen::Vector3d q = (p - centre).cwiseQuotient(radii);
    const double k0 = q.norm();
    const double k1 = q.cwiseQuotient(radii).norm();
    return k1 > 0 ? k0 * (k0 - 1) / k1 : -radii.minCoeff();
  };
}

Field HalfSpace(const Eigen::Vector3d& normal, double offset) {
  const double length = normal.norm();
  CHECK_GT(length, 0);
  return [=](const Eigen::Vector3d& p) {
    return (normal.dot(p) - offset) / length;
  };
}

Field Sweep(const std::vector<SweepNode>& nodes) {
  std::vector<Eigen::Vector4d> controls;
  for (const SweepNode& node : nodes) {
    controls.emplace_back(
        node.centre.x(), node.centre.y(), node.centre.z(), node.radius);
  }
  std::vector<SweepSpan> spans;
  const std::vector<Eigen::Vector4d> curve =
      SampleCatmullRom(controls, kSamplesPerSweepSpan, false);
  for (size_t first = 0; first + 1 < curve.size();
       first += kSamplesPerSweepSpan) {
    SweepSpan span;
    span.nodes.assign(curve.begin() + first,
                      curve.begin() + first + kSamplesPerSweepSpan + 1);
    for (const Eigen::Vector4d& node : span.nodes) {
      span.centres.extend(node.head<3>());
      span.largest_radius = std::max(span.largest_radius, node[3]);
    }
    spans.push_back(span);
  }
  return [spans](const Eigen::Vector3d& p) {
    double distance = std::numeric_limits<double>::infinity();
    for (const SweepSpan& span : spans) {
      const double least =
          span.centres.exteriorDistance(p) - span.largest_radius;
      if (least >= distance) continue;
      distance = std::min(
          distance,
          least > kFarFromSweep ? least : DistanceToSweepSpan(span, p));
    }
    return distance;
  };
}

Field Union(Field a, Field b, double width) {
  return [a = std::move(a), b = std::move(b), width](const Eigen::Vector3d& p) {
    return SmoothMin(a(p), b(p), width);
  };
}

Field Intersection(Field a, Field b, double width) {
  return [a = std::move(a), b = std::move(b), width](const Eigen::Vector3d& p) {
    return SmoothMax(a(p), b(p), width);
  };
}

Field Difference(Field a, Field b, double width) {
  return [a = std::move(a), b = std::move(b), width](const Eigen::Vector3d& p) {
    return SmoothMax(a(p), -b(p), width);
  };
}

Field Offset(Field field, double distance) {
  return [field = std::move(field), distance](const Eigen::Vector3d& p) {
    return field(p) - distance;
  };
}

Field Rough(Field field, double amplitude, double wavelength, uint32_t seed) {
  return [=, field = std::move(field)](const Eigen::Vector3d& p) {
    const double value = field(p);
    // Far from the surface the bumps make no difference.
    if (std::abs(value) > 4 * amplitude + 1) return value;
    return value + amplitude * ValueNoise(p / wavelength, seed);
  };
}

}  // namespace musclewarp::phantom
