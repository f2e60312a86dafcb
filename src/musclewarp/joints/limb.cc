// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/joints/limb.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <vector>

#include "musclewarp/joints/joint_limits.h"
#include "musclewarp/joints/knee_verdict.h"

namespace musclewarp {
namespace {

// Returns the sphere that covers most of itself. On coarse voxels normals see
// the steps between them, so that those of an uncertain head are averaged.
std::optional<SphereFit> FindHead(const SurfacePoints& femur) {
  std::optional<SphereFit> head = FindSphere(femur, {});
  if (head && 100 * head->coverage >= kJointSearch.head.uncertain_coverage) {
    return head;
  }
  const std::optional<SphereFit> smooth = FindSphere(
      WithAveragedNormals(femur, kJointSearch.head.coarse_normals), {});
  const bool is_better = smooth && (!head || smooth->coverage > head->coverage);
  return is_better ? smooth : head;
}

// Returns the shaft of a piece of a bone along a known direction.
Axis ShaftAlong(const SurfacePoints& bone, const Eigen::Vector3d& up) {
  const Eigen::VectorXd height = bone.points * up;
  const double low = height.minCoeff(), high = height.maxCoeff();
  const SurfacePoints upper = Filtered(bone, [&](int row) {
    return height[row] >= low + kJointSearch.head.piece_from * (high - low);
  });
  return {upper.points.colwise().mean().transpose(), up};
}

// Returns the product of both widths of a bone in the third of its length at
// one end, mm^2.
double SectionOf(const SurfacePoints& bone, const Eigen::Vector3d& end) {
  const Eigen::VectorXd height = bone.points * end;
  const double low = height.minCoeff(), high = height.maxCoeff();
  const SurfacePoints third = Filtered(
      bone, [&](int row) { return height[row] >= high - (high - low) / 3; });
  const Eigen::Vector3d across = end.unitOrthogonal();
  double section = 1;
  for (const Eigen::Vector3d& direction :
       {across, Eigen::Vector3d(end.cross(across))}) {
    const Eigen::VectorXd place = third.points * direction;
    section *= place.maxCoeff() - place.minCoeff();
  }
  return section;
}

// Returns the possible shafts of a piece of a femur, upwards, along each of its
// principal directions: the longest direction of a short piece may lie across.
// The upper third of a lower piece is slimmer than its lower third
// (HeadSearch::largest_section).
std::vector<Axis> PossibleShafts(const SurfacePoints& femur) {
  const Eigen::RowVector3d middle = femur.points.colwise().mean();
  const Points centered = femur.points.rowwise() - middle;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      centered.transpose() * centered);
  std::vector<Axis> shafts;
  for (int column = 2; column >= 0; --column) {
    const Eigen::Vector3d direction = solver.eigenvectors().col(column);
    for (const double sign : {1.0, -1.0}) {
      const Eigen::Vector3d up = sign * direction;
      if (SectionOf(femur, up) >
          kJointSearch.head.largest_section * SectionOf(femur, -up)) {
        continue;
      }
      shafts.push_back(ShaftAlong(femur, up));
    }
  }
  return shafts;
}

// Adds the knee with the most surface on a cylinder, preferably one whose
// verdict is not failed.
void AddKneeWithoutHead(const SurfacePoints& femur,
                        const std::optional<Eigen::Vector3d>& up,
                        FemurShape* shape) {
  shape->is_up_known = up.has_value();
  const std::vector<Axis> shafts =
      up ? std::vector<Axis>{ShaftAlong(femur, *up)} : PossibleShafts(femur);
  int best = -1;
  for (const Axis& shaft : shafts) {
    FemurShape candidate = *shape;
    const double radius = kJointSearch.head.usual_head_radius;
    candidate.directions = DirectionsOfFemur(femur, shaft, radius);
    candidate.knee = FitKnee(femur, *candidate.directions, radius);
    if (!candidate.knee) continue;
    const int points = candidate.HasKnee() ? candidate.knee->points : 0;
    if (points <= best) continue;
    best = points;
    shape->directions = candidate.directions;
    shape->knee = candidate.knee;
  }
}

}  // namespace

FemurShape ShapeOfFemur(const SurfacePoints& femur,
                        const std::optional<Eigen::Vector3d>& up) {
  FemurShape shape;
  if (femur.size() == 0) return shape;
  shape.head = FindHead(femur);
  if (shape.head) shape.best_coverage = shape.head->coverage;
  const double coverage = 100 * shape.best_coverage;
  if (QualityOf({kJointLimits.hip.coverage, coverage}) ==
          JointQuality::kFailed ||
      QualityOf({kJointLimits.hip.ball, coverage}) == JointQuality::kFailed) {
    shape.head.reset();
    AddKneeWithoutHead(femur, up, &shape);
    return shape;
  }
  const Eigen::Vector3d middle = femur.points.colwise().mean().transpose();
  shape.directions =
      DirectionsOfFemur(femur,
                        ShaftOf(femur, shape.head->sphere.center - middle),
                        shape.HeadRadius());
  shape.knee = FitKnee(femur, *shape.directions, shape.HeadRadius());
  return shape;
}

bool FemurShape::HasKnee() const {
  return knee && JudgeKnee(*this).quality != JointQuality::kFailed;
}

std::optional<Side> FemurShape::ShapeSide() const {
  if (!head || !HasKnee()) return std::nullopt;
  const Eigen::Vector3d way = head->sphere.center - knee->cylinder.axis.point;
  return way.dot(directions->left) > 0 ? Side::kRight : Side::kLeft;
}

std::optional<Eigen::Matrix3d> FemurShape::Axes() const {
  if (!head || !HasKnee()) return std::nullopt;
  const Axis& axis = knee->cylinder.axis;
  Eigen::Matrix3d axes;
  axes.col(1) = (head->sphere.center - axis.point).normalized();
  axes.col(0) = axes.col(1).cross(-axis.direction).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

}  // namespace musclewarp
