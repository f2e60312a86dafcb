// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/render/image.h"

namespace musclewarp {

// Makes the shape of a surface easier to see in a still picture: by dark
// outlines, and by dark folds. Both work on the picture and the depth of its
// pixels, after the drawing.

// The depth of every pixel, rows from the top left: how far the viewer sees, as
// a share of the height of a panel, or kBackground where there is nothing.
struct DepthMap {
  static constexpr float kBackground = 1e9f;
  int width = 0;
  int height = 0;
  std::vector<float> depth;  // width * height
};

// Darkens the rim of what stands in front of something else by more than 0.012
// of the height of a panel, in a line of about `line_width` pixels.
// Precondition (CHECKed): map and image have the same size.
void DrawOutlines(const DepthMap& map, int line_width, Image* image);

// Darkens what lies deeper than its surroundings, because light does not reach
// into folds: Luft, Colditz, Deussen, "Image Enhancement by Unsharp Masking the
// Depth Buffer", 2006. The background is not changed. Precondition (CHECKed):
// map and image have the same size.
void DarkenFolds(const DepthMap& map, Image* image);

}  // namespace musclewarp
