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
  // 0 is invisible, 1 is opaque.
  double opacity = 1;
  // If true, the camera is placed so that the whole mesh is in the picture. If
  // false, parts of the mesh may be outside, like the shaft of a long bone.
  bool fit = true;
  // #F: the colour of each triangle, in place of `color`; may be empty.
  std::vector<Color> triangle_colors;
};

// One of the scenes that stand side by side in a picture, such as two frames of
// a motion.
struct PicturePanel {
  // The text below the scene; "" for none.
  std::string caption;
  std::vector<PictureMesh> meshes;
};

// An entry of the legend below the scenes: a patch of the colour, then the
// text.
struct LegendEntry {
  std::string text;
  Color color;
};

// How a picture is drawn.
struct PictureOptions {
  // The size of the whole picture, pixels.
  int width = 1200;
  int height = 1000;
  // The picture is drawn this many times as large in both directions and then
  // averaged, for smooth edges.
  int oversampling = 2;
  // Edges at which the surface bends by more than this angle stay sharp, others
  // are shaded smoothly; degrees.
  double feature_angle = 60;
  // If true, the rims of opaque meshes are drawn dark (see DrawOutlines).
  bool outlines = true;
  // If true, what lies deep in folds is drawn darker (see DarkenFolds).
  bool folds = true;
  // The legend; none if empty.
  std::vector<LegendEntry> legend;
};

// The least width and height of a panel, pixels.
constexpr int kLeastPanelSize = 16;

// Draws the panels from left to right on white, in parallel projection and all
// at the same scale, which the largest determines.
// Preconditions: there is a mesh with `fit`, there are as many colours of
// triangles as triangles or none, opacities are in [0, 1], and the
// texts leave every panel kLeastPanelSize pixels in both directions. Throws
// InputError if the machine has no OpenGL.
Image DrawPicture(const std::vector<PicturePanel>& panels,
                  const View& view,
                  const PictureOptions& options);

}  // namespace musclewarp
