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

// A plane that keeps two surfaces apart during a step: a triangle lies beyond a
// plane if its corners do, so that each plane becomes a half-space for a few
// vertices, independent of all other vertices.
//
// Above the plane are vertices of a muscle, with normal . p >= level +
// half_gap. Below it are vertices of a muscle, with normal . p <= level -
// half_gap, or a bone, which does not move in the step.
struct SeparatingPlane {
  static constexpr int kBone = -1;

  int muscle_above = -1;
  int muscle_below = kBone;
  int bone = 0;  // which one, if the plane is that of a bone
  Eigen::RowVector3i above = Eigen::RowVector3i::Constant(-1);  // vertices
  Eigen::RowVector3i below = Eigen::RowVector3i::Constant(-1);  // of a muscle

  Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();  // of unit length

  // The plane of a bone has its final level, mm. The level of a plane between
  // muscles follows the muscles while they are relaxed (PlaneSet).
  double level = 0;
  double half_gap = 0;  // mm; zero for a bone, whose level includes the gap

  // Between the two triangles before the step, mm; zero for a bone.
  double distance = 0;

  // A vertex that both triangles of one muscle share and that stays on the
  // plane, or -1.
  int shared_corner = -1;

  bool IsOfBone() const { return muscle_below == kBone; }
  bool IsWithinOneMuscle() const { return muscle_above == muscle_below; }
};

// Returns the plane between two triangles that are separated before a step, as
// their rotations in the step turn it: triangle `f` of muscle `a` is above, `g`
// of muscle `b` below. Both may be of one muscle.
SeparatingPlane PlaneBetween(const ContactStep& step,
                             int a,
                             int f,
                             int b,
                             int g,
                             const TriangleSeparation& before,
                             double half_gap);

// Returns the plane that keeps triangle `f` of a muscle in a half-space given
// in the rest pose of a bone. It moves with the bone: in the frame of the bone
// it stands still and, half-spaces being convex, so does the straight path of a
// vertex from before the step to after it stay within. No muscle passes through
// a bone between two states.
SeparatingPlane PlaneOfBone(const ContactStep& step,
                            int muscle,
                            int f,
                            int bone,
                            const HalfSpace& at_rest);

// Finds planes between all surfaces that may meet in a step: pairs of triangles
// of two muscles, and triangles of muscles with bones, that are near each other
// before the step or where the step carries them. Planes between the sheets of
// one muscle are found by sheet_planes.h, and against crossings that are left
// by defects.h.
//
// `predicted` are the trees of PredictedTrees(step). They hold other boxes
// afterwards. The order of the planes depends on the meshes only.
std::vector<SeparatingPlane> FindSeparatingPlanes(
    const StepOptions& options,
    const ContactStep& step,
    std::vector<TriangleBvh>* predicted);

}  // namespace musclewarp
