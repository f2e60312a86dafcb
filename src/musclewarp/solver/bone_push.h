// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "musclewarp/geometry/mean_value_coordinates.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/proximity/distance_field.h"
#include "musclewarp/scene/scene_pose.h"
#include "musclewarp/solver/bone_push_options.h"

namespace musclewarp {

struct MuscleModel;

// A bone at rest: how far a place is from it.
struct BoneField {
  std::string body;
  std::shared_ptr<const DistanceField> field;
};

// What bones need to push the free shape of a muscle aside, which without
// contact is the least of its linear energy. The push is the displacement dX of
// its coarse vertices that is followed along the way from rest to a pose: in
// each step it minimises
//
//   1/2 |J_f dX|^2 + m/2 |J_f (dX - dX before)|^2
//     + k sum_vb phi(c_vb - d_b(p_v + W_v dX))
//
// where d_b is the distance to bone b, p_v is the place of sample
// v without the push and c_vb is what it keeps: its distance at rest, and at
// most a clearance, so that a muscle may lie in a bone as deep as it does at
// rest. So bending, lines and attachments resist bones as they resist contact.
// The second term, with m = 1, makes it a flow that is a step behind the least
// energy, which alone jumps where a muscle slips over a bone. In the pose
// itself the push goes on to the least energy, unless that is far from there. S
// samples, N coarse vertices and B bones.
struct BonePush {
  BonePushOptions options;
  std::vector<BoneField> bones;
  RowMajorMatrix fine_from_coarse;  // S x N: the rows of W of the samples
  Eigen::MatrixXd clearances;       // S x B, mm: c
  RowMajorMatrix reach;             // S x N: how a force on a sample moves X
  RowMajorMatrix response;          // S x S: and the samples
  double stiffness = 0;             // k
};

// Prepares the push of a muscle, whose normal matrix is factorised. Returns
// null if it has no lines or there are no bones. Precondition (CHECKed): the
// options are valid.
std::shared_ptr<const BonePush> PrepareBonePush(
    const BonePushOptions& options,
    const std::vector<BoneField>& bones,
    const MuscleModel& model);

// Returns how many samples of a muscle bones push, for a hull with so many
// vertices.
int NumPushSamples(const BonePushOptions& options, int coarse_vertices);

// Follows the push of a muscle along a way: `way` are poses from rest on, and
// `free` are its coarse vertices without the push in each of them, N x 3, mm.
// Returns the displacements in each pose, N x 3, mm: all zero as long as
// nothing touches.
std::vector<Points> FollowPush(const BonePush& push,
                               const std::vector<ScenePose>& way,
                               const std::vector<Points>& free);

}  // namespace musclewarp
