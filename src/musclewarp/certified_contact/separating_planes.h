// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "musclewarp/certified_contact/contact_step.h"
#include "musclewarp/certified_contact/step_options.h"
#include "musclewarp/proximity/triangle_separation.h"

namespace musclewarp {

// A plane that keeps two surfaces apart during a step. A triangle lies on one
// side of a plane if its corners do, so each plane constrains a few vertices to
// a half-space, independently of all other vertices.
//
// Above the plane are vertices of a muscle, with normal . p >= level +
// half_gap. Below it are vertices of a muscle, with normal . p <= level -
// half_gap, or a bone, which is fixed at its position after the step.
struct SeparatingPlane {
  static constexpr int kBone = -1;

  int muscle_above = -1;
  int muscle_below = kBone;
  int bone = 0;  // its index, if the plane is that of a bone
  Eigen::RowVector3i above = Eigen::RowVector3i::Constant(-1);  // vertices
  Eigen::RowVector3i below = Eigen::RowVector3i::Constant(-1);  // of a muscle

  // Further vertices of the muscle below, of triangles behind the one below,
  // for which the plane serves, too. In rising order.
  std::vector<int> also_below;

  Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();  // of unit length

  // The plane of a bone has its final level, mm. The level of a plane between
  // muscles follows the muscles while they are relaxed (PlaneSet).
  double level = 0;
  double half_gap = 0;  // mm; zero for a bone, whose level includes the gap

  // The distance of the two triangles before the step, mm; zero for a bone.
  double distance = 0;

  // The shared vertex of two triangles of one muscle, through which the plane
  // passes, or -1.
  int shared_corner = -1;

  bool IsOfBone() const { return muscle_below == kBone; }
  bool IsWithinOneMuscle() const { return muscle_above == muscle_below; }
};

// Returns the plane between two triangles that are separated before a step,
// rotated by the mean rotation of both triangles in the step: triangle `f` of
// muscle `a` is above, `g` of muscle `b` below. Both may be of one muscle.
SeparatingPlane PlaneBetween(const ContactStep& step,
                             int a,
                             int f,
                             int b,
                             int g,
                             const TriangleSeparation& before,
                             double half_gap);

// Finds planes between the triangles of two muscles that are near each other
// before the step or at the prediction. A triangle of the muscle above gets a
// plane to the nearest triangle below, which also serves for those behind that
// one, and so on with the triangles that are left. Above is the muscle with
// fewer triangles, which needs fewer planes. bone_planes.h finds the planes of
// bones, sheet_planes.h those between the sheets of one muscle, and defects.h
// those against remaining crossings.
//
// `predicted`: the trees of PredictedTrees(step). The order of the planes
// depends on the meshes only.
std::vector<SeparatingPlane> FindPlanesBetweenMuscles(
    const StepOptions& options,
    const ContactStep& step,
    const std::vector<TriangleBvh>& predicted);

}  // namespace musclewarp
