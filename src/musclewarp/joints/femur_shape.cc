// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/femur_shape.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "musclewarp/joints/joint_search.h"

namespace musclewarp {
namespace {

// The direction in which points spread most.
Eigen::Vector3d LongestDirection(const Points& points) {
  const Eigen::RowVector3d mean = points.colwise().mean();
  const Points centered = points.rowwise() - mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      centered.transpose() * centered);
  return solver.eigenvectors().col(2);
}

// The direction at right angles to `up` in which points spread most.
Eigen::Vector3d WidestDirection(const Points& points,
                                const Eigen::Vector3d& up) {
  const Eigen::Matrix3d flat =
      Eigen::Matrix3d::Identity() - up * up.transpose();
  return LongestDirection(points * flat);
}

}  // namespace

Axis ShaftOf(const SurfacePoints& bone, const Eigen::Vector3d& up) {
  constexpr int kSlices = 20;  // 9 mm of a femur
  constexpr double kFrom = kJointSearch.head.shaft_from;
  constexpr double kTo = kJointSearch.head.shaft_to;
  Axis shaft;
  shaft.direction = LongestDirection(bone.points);
  shaft.point = bone.points.colwise().mean().transpose();
  // The mean of a slice across a tilted line is off the line by less each time.
  for (int round = 0; round < 3; ++round) {
    const Eigen::VectorXd along = bone.points * shaft.direction;
    const double low = along.minCoeff();
    const double length = along.maxCoeff() - low;
    std::vector<Eigen::Vector3d> sums(kSlices, Eigen::Vector3d::Zero());
    std::vector<int> counts(kSlices, 0);
    for (int i = 0; i < bone.size(); ++i) {
      const double part = ((along[i] - low) / length - kFrom) / (kTo - kFrom);
      if (!(part >= 0 && part < 1)) continue;
      const int slice = static_cast<int>(part * kSlices);
      sums[slice] += bone.points.row(i).transpose();
      ++counts[slice];
    }
    Points middles(0, 3);
    for (int slice = 0; slice < kSlices; ++slice) {
      if (counts[slice] == 0) continue;
      middles.conservativeResize(middles.rows() + 1, 3);
      middles.bottomRows(1) = (sums[slice] / counts[slice]).transpose();
    }
    if (middles.rows() < 2) break;
    shaft.point = middles.colwise().mean().transpose();
    shaft.direction = LongestDirection(middles);
  }
  if (shaft.direction.dot(up) < 0) shaft.direction = -shaft.direction;
  return shaft;
}

BoneDirections DirectionsOfFemur(const SurfacePoints& femur,
                                 const Axis& shaft,
                                 double head_radius) {
  const double end_height = kJointSearch.head.end_height * head_radius;
  BoneDirections directions;
  directions.shaft = shaft;
  directions.up = directions.shaft.direction;
  const Eigen::VectorXd height = femur.points * directions.up;
  directions.lowest = height.minCoeff();
  const SurfacePoints end = Filtered(femur, [&](int row) {
    return height[row] <= directions.lowest + end_height;
  });
  const Eigen::Vector3d widest = WidestDirection(end.points, directions.up);
  directions.back = widest.cross(directions.up);
  const Eigen::VectorXd reach =
      (end.points.rowwise() - directions.shaft.point.transpose()) *
      directions.back;
  double back = reach.maxCoeff(), front = -reach.minCoeff();
  if (back < front) {
    std::swap(back, front);
    directions.back = -directions.back;
  }
  directions.back_to_front = back / std::max(front, 1e-3);
  directions.left = directions.back.cross(directions.up);
  return directions;
}

}  // namespace musclewarp
