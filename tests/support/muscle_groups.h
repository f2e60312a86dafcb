// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "musclewarp/paper_contact/group_contact.h"
#include "musclewarp/solver/muscle_model.h"
#include "musclewarp/solver/muscle_target.h"
#include "musclewarp/solver/volume_constraint.h"

namespace musclewarp {

// Two spindles side by side along z, whose surfaces cross by 2 mm (a negative
// gap), and a ball of bone 1 mm deep in the second one; all at rest.
struct TouchingSpindles {
  explicit TouchingSpindles(ContactLevel level, double gap = -2);

  GroupContact Contact() const;
  std::vector<const MuscleModel*> Models() const;
  std::vector<MuscleTarget> Targets() const;
  std::vector<MuscleState> RestStates() const;

  // Of the fine meshes in each other and in the bone.
  int VerticesInside(const std::vector<MuscleState>& states) const;
  double VolumeRatio(int muscle, const MuscleState& state) const;

  GroupContactOptions options;
  std::vector<MuscleModel> models;
  TriangleSoup bone;
  std::vector<std::unique_ptr<ContactShape>> coarse_shapes, fine_shapes;
  std::unique_ptr<ContactShape> bone_shape;
};

}  // namespace musclewarp
