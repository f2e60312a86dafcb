// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "musclewarp/anatomy/bone.h"
#include "musclewarp/joints/found_joint.h"

namespace musclewarp {

// In which pose the coordinates of joints are 0.
enum class ZeroPose {
  kAnatomy,  // where the frames of both bones are parallel, as far as known
  kScan,     // in the pose of the scan
};

struct ArticulationOptions {
  // The joints to find; empty: all for which there are bones.
  std::vector<JointKind> joints;

  // The side on which joints are found, which is also the side of bones whose
  // side nothing else tells; none: both sides.
  std::optional<Side> side;

  ZeroPose zero = ZeroPose::kAnatomy;

  // Where +x, +y and +z of the frame of the bones point, as `axes` of a scene;
  // empty if that is not known.
  std::string axes = "LPS";

  // Joints that replace those found, by kind and side (joints_file.h).
  std::vector<FoundJoint> given;
};

// A body that is fixed to another one.
struct Weld {
  std::string parent, child;  // bodies; the parent may be "ground"
};

// A skeleton with joints: what a model, motions and scenes are made of.
struct Articulation {
  std::vector<Bone> bones;  // with side and body, as far as they are known

  // The bodies of the bones, in an order in which a body comes after the one
  // that carries it.
  std::vector<std::string> bodies;

  // The joints that were asked for, failed ones too, from the trunk outwards,
  // and how all bodies are connected that are not the child of a joint found.
  std::vector<FoundJoint> joints;
  std::vector<Weld> welds;

  // The size of the skeleton relative to a human one (SkeletonSizeOf).
  double size = 1;

  // Notes for the user beside the verdicts, a sentence each.
  std::vector<std::string> notes;
};

// Finds the joints of a skeleton on the shapes of its bones (mm, one frame).
//
// A femur tells its side by its shape; other bones by their names, by the
// nearest bone that has a side, or by their place in the image. Bones of
// unknown kind belong to no joint and stay fixed to their body.
//
// A skeleton far from human size (SkeletonSizeOf) is scaled to it while its
// joints are found, so that all lengths of the method apply.
//
// Throws InputError, which begins with the name of the bone, if the shape of a
// femur contradicts its name or its place in the image, as in a mirrored image;
// and if a joint of `options.joints` lacks its bones, or no joint has any.
Articulation Articulate(std::vector<Bone> bones,
                        const ArticulationOptions& options);

}  // namespace musclewarp
