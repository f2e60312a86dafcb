// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "musclewarp/render/image.h"

namespace musclewarp {

// How far the viewer sees in every pixel, rows from the top left, in shares of
// the height of a panel; kBackground where there is nothing.
struct DepthMap {
  static constexpr float kBackground = 1e9f;
  int width = 0;
  int height = 0;
  std::vector<float> depth;
};

// Darkens the rim of what stands in front by more than 0.012 of the height, in
// a line of about `line_width` pixels. Precondition: both have one size.
void DrawOutlines(const DepthMap& map, int line_width, Image* image);

// Darkens what lies deeper than its surroundings, as light does not get into
// folds: Luft, Colditz, Deussen, "Image Enhancement by Unsharp Masking the
// Depth Buffer", 2006. The background stays. Precondition: both have one size.
void DarkenFolds(const DepthMap& map, Image* image);

}  // namespace musclewarp
