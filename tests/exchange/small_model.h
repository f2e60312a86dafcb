// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "musclewarp/exchange/element_model.h"

namespace musclewarp {

// Two balls of muscle and one of bone, 3 mm apart in a row along x, as a model
// without a mesher: "psoas" with fibres along (0, 0.6, 0.8) and three vertices
// attached to the body "pelvis", "iliacus" with neither, and "femur", of the
// body "thigh".
struct SmallModel {
  RecordedNames names;
  RecordedPose pose;
  RecordedAttachments attachments;
  std::vector<MeshGap> gaps;
  TetrahedralMesh mesh;

  ElementModel Model() const;
};

SmallModel MakeSmallModel();

}  // namespace musclewarp
