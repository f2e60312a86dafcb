// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "musclewarp/mesh/triangle_soup.h"

namespace musclewarp {

// A side of the body.
enum class Side { kRight, kLeft };

// What a bone is, as far as joints are concerned.
enum class BoneKind {
  kOther,    // of no joint
  kPelvis,   // both hip bones in one mesh, with or without the sacrum
  kHipBone,  // one of them
  kSacrum,
  kFemur,
  kPatella,
  kTibia,  // may have the fibula in the same mesh
  kFibula,
  kTalus,
  kFoot,  // any bone below or before the talus, or several in one mesh
  kScapula,
  kClavicle,
  kHumerus,
  kUlna,
  kRadius,
};

// A bone of one person, in the frame of the image that it was segmented from.
struct Bone {
  std::string name;
  BoneKind kind = BoneKind::kOther;
  std::optional<Side> side;  // none in the middle, or if it is not known

  // The body of the model to which it belongs; empty: that of its kind.
  std::string body;

  TriangleSoup mesh;  // mm
};

// "right", "left".
std::string ToString(Side side);

// "_r", "_l": the end of names of bodies and coordinates in OpenSim.
std::string SuffixOf(Side side);

}  // namespace musclewarp
