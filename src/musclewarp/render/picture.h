// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/geometry/view.h"
#include "musclewarp/mesh/triangle_soup.h"
#include "musclewarp/render/image.h"

namespace musclewarp {

// A surface in a picture.
struct PictureMesh {
  TriangleSoup surface;
  Color color;
  double opacity = 1;
  // The camera makes room for it; others may reach out of the picture.
  bool fit = true;
};

// One of the scenes that stand side by side in a picture.
struct PicturePanel {
  std::string caption;  // below it, may be empty
  std::vector<PictureMesh> meshes;
};

// A line of the legend below the scenes: a patch of the colour, then the text.
struct LegendEntry {
  std::string text;
  Color color;
};

struct PictureOptions {
  // Size of the whole picture, pixels.
  int width = 1200;
  int height = 1000;
  // Every pixel is the mean of oversampling^2, for smooth edges.
  int oversampling = 2;
  // Edges sharper than this are drawn as edges, others are shaded over;
  // degrees.
  double feature_angle = 60;
  // Darkens the rims of opaque meshes and what lies deep in folds.
  bool outlines = true;
  bool folds = true;
  // Empty: no legend.
  std::vector<LegendEntry> legend;
};

// Pixels, width and height.
constexpr int kLeastPanelSize = 16;

// Draws the panels from left to right on white, in parallel projection, all
// with the camera that fits the largest. Preconditions: there is a mesh to fit,
// opacities are in [0, 1], every panel has kLeastPanelSize above the texts.
// Throws InputError if the machine has no OpenGL.
Image DrawPicture(const std::vector<PicturePanel>& panels,
                  const View& view,
                  const PictureOptions& options);

}  // namespace musclewarp
