// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>

#include "musclewarp/anatomy/bone.h"
#include "musclewarp/joints/femur_shape.h"
#include "musclewarp/joints/joint_search.h"
#include "musclewarp/joints/knee.h"
#include "musclewarp/joints/sphere_fit.h"

namespace musclewarp {

// The bones of one side, as points on their surfaces.
struct Limb {
  Side side = Side::kRight;

  // The points of all bones of a kind; bones in the middle of the body are of
  // both limbs.
  std::map<BoneKind, SurfacePoints> surfaces;

  // Where forward, up and right are in the frame of the image, in columns; none
  // if the image does not say or the bones contradict it.
  std::optional<Eigen::Matrix3d> image_axes;

  // The same of the pelvis (PelvisAxes), if both hip bones are there, or one
  // and the image says where its mirror image is.
  std::optional<Eigen::Matrix3d> pelvis_axes;

  // Returns the points of a kind, or null if there are none.
  const SurfacePoints* Find(BoneKind kind) const {
    const auto found = surfaces.find(kind);
    return found == surfaces.end() ? nullptr : &found->second;
  }
};

// What was measured on the shape of a femur.
struct FemurShape {
  std::optional<SphereFit> head;  // none without one, or too little of one
  double best_coverage = 0;       // of the best sphere, a head or not

  // Without a head these rest on the image, or on the end that fits better.
  std::optional<BoneDirections> directions;
  std::optional<KneeFit> knee;
  bool is_up_known = true;  // false for a piece that nothing tells the ends of

  double HeadRadius() const {
    return head ? head->sphere.radius : kJointSearch.head.usual_head_radius;
  }

  // True for a knee that does not fail (knee_verdict.h).
  bool HasKnee() const;

  // The side that the shape tells: the head of a right femur lies on the left
  // of its knee. None without a head and a knee.
  std::optional<Side> ShapeSide() const;

  // The axes of the femur, in columns: y from the knee to the head, z to the
  // right at right angles to y in the plane of both and the axis of the knee
  // (Wu et al. 2002). None without a head and a knee.
  std::optional<Eigen::Matrix3d> Axes() const;
};

// Fits the head and the knee of a femur, which may be cut. `up` is the upward
// direction of the image, for a femur without its head.
FemurShape ShapeOfFemur(const SurfacePoints& femur,
                        const std::optional<Eigen::Vector3d>& up);

}  // namespace musclewarp
