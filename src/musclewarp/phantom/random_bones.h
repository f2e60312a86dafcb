// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "musclewarp/base/random_draws.h"
#include "musclewarp/phantom/field.h"
#include "musclewarp/phantom/phantom_scene.h"

namespace musclewarp::phantom {

// A bone of a random scene. Bones form a tree: the first is the root, which
// stays where it is, and every other one turns in a joint against its parent.
// Lengths are in mm, positions are those of the rest pose.
struct RandomBone {
  // "rod_2" or "plate_1"; the body of the bone has the same name.
  std::string name;
  // The index of the parent in the list of bones; -1 for the root.
  int parent = -1;
  // The point about which the bone turns against its parent.
  Eigen::Vector3d joint = Eigen::Vector3d::Zero();
  // The direction of the length of the bone, away from the joint.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  // True if the bone is beside its parent, as an ulna beside a radius. Such a
  // bone mainly turns about its own length.
  bool is_beside_parent = false;
  // The thickness of its thinnest part, and its breadth across `axis`.
  double thickness = 0;
  double breadth = 0;
  // The solid before it has bumps.
  Field field;
  PhantomMesh mesh;
};

// Draws two to six bones: rods with thick ends, plates, and rods whose head is
// in a socket of the parent. They are 80 to 400 mm long, and no two are nearer
// to each other than 1 mm. The bumps of the meshes depend on the draws as well.
std::vector<RandomBone> DrawBones(RandomDraws* draws);

// Returns the least distance that any two bones have in a pose, mm, negative
// where they cross, measured at the vertices of each mesh to the solid of the
// other bone. `target_from_rest` has an entry for every bone.
double LeastBoneDistance(const std::vector<RandomBone>& bones,
                         const std::vector<Eigen::Matrix4d>& target_from_rest);

}  // namespace musclewarp::phantom
