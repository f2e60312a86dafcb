// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/muscle_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace musclewarp::phantom {
namespace {

using Eigen::Vector3d;

// Where a cross section is tested, as a share of its half width, and the share
// of the half thickness that the strap has there (see StrapNode).
struct Sample {
  double place;
  double thickness_fraction;
};
constexpr Sample kSamples[] = {{0, 1}, {-0.8, 0.744}, {0.8, 0.744}};

// How much deeper than allowed the strap is in the obstacle at one sample.
double ExcessAt(const Vector3d& p,
                double half_thickness,
                const PathObstacle& obstacle) {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  if (obstacle.box.exteriorDistance(p) > half_thickness) return kNone;
  return half_thickness - obstacle.depth - obstacle.field(p);
}

// Moves a node out of the obstacle, by at most 2 mm for each sample.
void PushOut(const PathObstacle& obstacle, StrapNode* node) {
  constexpr double kLargestPush = 2;  // mm
  for (const Sample& sample : kSamples) {
    const Vector3d p =
        node->centre + sample.place * node->half_width * node->across;
    const double excess =
        ExcessAt(p, sample.thickness_fraction * node->half_thickness, obstacle);
    if (excess <= 0) continue;
    node->centre +=
        std::min(excess, kLargestPush) * NormalOf(obstacle.field, p);
  }
}

// Lays the cross sections flat on the ground and turns them alike.
void Orient(const Field& ground, std::vector<StrapNode>* nodes) {
  constexpr int kPasses = 4;
  const int count = static_cast<int>(nodes->size());
  std::vector<Vector3d> tangents(count);
  for (int i = 0; i < count; ++i) {
    const StrapNode& before = (*nodes)[std::max(i - 1, 0)];
    const StrapNode& after = (*nodes)[std::min(i + 1, count - 1)];
    tangents[i] = (after.centre - before.centre).normalized();
    const Vector3d normal = NormalOf(ground, (*nodes)[i].centre);
    Vector3d across = tangents[i].cross(normal);
    const Vector3d& last = i > 0 ? (*nodes)[i - 1].across : (*nodes)[i].across;
    // Where the strap stands on the ground, the normal does not say how to lie.
    if (across.norm() < 0.3) across = last;
    (*nodes)[i].across = across.dot(last) < 0 ? Vector3d(-across) : across;
  }
  for (int pass = 0; pass < kPasses; ++pass) {
    for (int i = 0; i < count; ++i) {
      const Vector3d sum = 2 * (*nodes)[i].across +
                           (*nodes)[std::max(i - 1, 0)].across +
                           (*nodes)[std::min(i + 1, count - 1)].across;
      const Vector3d level = sum - sum.dot(tangents[i]) * tangents[i];
      if (level.norm() > 1e-3) (*nodes)[i].across = level.normalized();
    }
  }
}

}  // namespace

Vector3d NormalOf(const Field& field, const Vector3d& p) {
  constexpr double kStep = 0.05;  // mm
  Vector3d gradient;
  for (int axis = 0; axis < 3; ++axis) {
    gradient[axis] = field(p + kStep * Vector3d::Unit(axis)) -
                     field(p - kStep * Vector3d::Unit(axis));
  }
  const double norm = gradient.norm();
  return norm > 1e-9 ? Vector3d(gradient / norm) : Vector3d::UnitZ();
}

double Excess(const StrapNode& node, const PathObstacle& obstacle) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Sample& sample : kSamples) {
    largest = std::max(
        largest,
        ExcessAt(node.centre + sample.place * node.half_width * node.across,
                 sample.thickness_fraction * node.half_thickness,
                 obstacle));
  }
  return largest;
}

std::vector<StrapNode> TautPath(std::vector<StrapNode> nodes,
                                const std::vector<PathObstacle>& obstacles,
                                const Field& ground) {
  constexpr int kRounds = 120;
  constexpr int kLastRounds = 8;  // in which nothing pulls any more
  constexpr int kOrientInterval = 10;
  for (int round = 0; round < kRounds; ++round) {
    if (round % kOrientInterval == 0) Orient(ground, &nodes);
    if (round < kRounds - kLastRounds) {
      // Over-relaxed: the string is to be taut after few rounds.
      constexpr double kPull = 0.9;
      for (size_t i = 1; i + 1 < nodes.size(); ++i) {
        const Vector3d middle =
            0.5 * (nodes[i - 1].centre + nodes[i + 1].centre);
        nodes[i].centre += kPull * (middle - nodes[i].centre);
      }
    }
    for (size_t i = 1; i + 1 < nodes.size(); ++i) {
      for (const PathObstacle& obstacle : obstacles) {
        PushOut(obstacle, &nodes[i]);
      }
    }
  }
  return nodes;
}

Points CentresOf(const std::vector<StrapNode>& nodes) {
  Points centres(static_cast<Eigen::Index>(nodes.size()), 3);
  for (size_t i = 0; i < nodes.size(); ++i) {
    centres.row(i) = nodes[i].centre.transpose();
  }
  return centres;
}

}  // namespace musclewarp::phantom
