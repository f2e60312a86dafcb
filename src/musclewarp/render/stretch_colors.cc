// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/stretch_colors.h"

#include <algorithm>
#include <array>
#include <limits>

#include "musclewarp/frames/triangle_stretch.h"

namespace musclewarp {
namespace {

struct Band {
  double up_to;
  const char* text;
  Color color;
};

constexpr std::array<Band, 5> kBands = {{
    {1.2, "stretch up to 1.2", {200, 216, 232}},
    {1.4, "1.2 to 1.4", {247, 205, 120}},
    {kStretchBeyondAnatomy, "1.4 to 1.6", {232, 135, 52}},
    {kStretchOfPatches, "1.6 to 2", {190, 48, 38}},
    {std::numeric_limits<double>::infinity(), "beyond 2", {70, 10, 60}},
}};

}  // namespace

std::vector<Color> StretchColors(const Points& rest,
                                 const Points& deformed,
                                 const Triangles& triangles) {
  std::vector<Color> colors;
  for (const double stretch : TriangleStretches(rest, deformed, triangles)) {
    colors.push_back(
        std::find_if(kBands.begin(), kBands.end() - 1, [&](const Band& band) {
          return stretch <= band.up_to;
        })->color);
  }
  return colors;
}

std::vector<LegendEntry> StretchLegend() {
  std::vector<LegendEntry> legend;
  for (const Band& band : kBands) legend.push_back({band.text, band.color});
  return legend;
}

}  // namespace musclewarp
