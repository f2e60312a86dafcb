// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/depth_cues.h"

#include <glog/logging.h>

#include <algorithm>

namespace musclewarp {
namespace {

void CheckSizes(const DepthMap& map, const Image& image) {
  CHECK_EQ(map.width, image.width);
  CHECK_EQ(map.height, image.height);
  CHECK_EQ(map.depth.size(), image.pixels.size());
}

void Darken(float factor, Color* color) {
  color->r = static_cast<std::uint8_t>(color->r * factor + 0.5f);
  color->g = static_cast<std::uint8_t>(color->g * factor + 0.5f);
  color->b = static_cast<std::uint8_t>(color->b * factor + 0.5f);
}

// The sum of depths and the number of the pixels that are not background.
struct Sum {
  double depth = 0;
  int count = 0;
};

// out[i] = sum of in[i - radius .. i + radius] along a line of `size` entries
// that lie `stride` apart.
void SumAlongLine(const Sum* in, Sum* out, int size, int stride, int radius) {
  Sum window;
  for (int i = -radius; i < size; ++i) {
    if (i + radius < size) {
      window.depth += in[(i + radius) * stride].depth;
      window.count += in[(i + radius) * stride].count;
    }
    if (i - radius - 1 >= 0) {
      window.depth -= in[(i - radius - 1) * stride].depth;
      window.count -= in[(i - radius - 1) * stride].count;
    }
    if (i >= 0) out[i * stride] = window;
  }
}

// Sums over squares of (2 radius + 1)^2 pixels.
std::vector<Sum> SumOverSquares(const DepthMap& map, int radius) {
  std::vector<Sum> sums(map.depth.size()), rows(map.depth.size());
  for (std::size_t i = 0; i < map.depth.size(); ++i) {
    if (map.depth[i] < DepthMap::kBackground) sums[i] = {map.depth[i], 1};
  }
  for (int y = 0; y < map.height; ++y) {
    SumAlongLine(
        &sums[y * map.width], &rows[y * map.width], map.width, 1, radius);
  }
  for (int x = 0; x < map.width; ++x) {
    SumAlongLine(&rows[x], &sums[x], map.height, map.width, radius);
  }
  return sums;
}

void DarkenBelow(const DepthMap& map, int radius, float most, Image* image) {
  // How much deeper than the mean a pixel must be to be fully dark, as a share
  // of the height.
  constexpr double kDeep = 0.02;
  const std::vector<Sum> sums = SumOverSquares(map, radius);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (map.depth[i] >= DepthMap::kBackground) continue;
    const double below = map.depth[i] - sums[i].depth / sums[i].count;
    if (below <= 0) continue;
    const float share = static_cast<float>(std::min(1.0, below / kDeep));
    Darken(1 - most * share, &image->pixels[i]);
  }
}

}  // namespace

void DrawOutlines(const DepthMap& map, int line_width, Image* image) {
  CheckSizes(map, *image);
  constexpr float kStep = 0.012f;
  constexpr float kDarkness = 0.55f;
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const int i = y * map.width + x;
      if (map.depth[i] >= DepthMap::kBackground) continue;
      float behind = map.depth[i];
      for (int dy = -line_width; dy <= line_width; ++dy) {
        for (int dx = -line_width; dx <= line_width; ++dx) {
          if (dx * dx + dy * dy > line_width * line_width) continue;
          const int u = std::clamp(x + dx, 0, map.width - 1);
          const int v = std::clamp(y + dy, 0, map.height - 1);
          behind = std::max(behind, map.depth[v * map.width + u]);
        }
      }
      if (behind - map.depth[i] > kStep) {
        Darken(1 - kDarkness, &image->pixels[i]);
      }
    }
  }
}

void DarkenFolds(const DepthMap& map, Image* image) {
  CheckSizes(map, *image);
  // Folds are found at two sizes, each given as a share of the height.
  DarkenBelow(map, map.height / 60 + 1, 0.40f, image);
  DarkenBelow(map, map.height / 20 + 1, 0.30f, image);
}

}  // namespace musclewarp
