// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "musclewarp/base/color.h"

namespace musclewarp {

// A picture in memory, so that what is drawn can be changed and tested before
// it is written. Rows start at the top left.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Color> pixels;  // width * height

  // The pixel in column x and row y. Preconditions: 0 <= x < width and
  // 0 <= y < height.
  const Color& At(int x, int y) const { return pixels[y * width + x]; }
  Color& At(int x, int y) { return pixels[y * width + x]; }
};

// Returns the image made smaller by `factor`: every pixel is the mean of a
// block of factor x factor pixels, which smooths the edges of what was drawn.
// Precondition (CHECKed): the factor divides width and height.
Image Downsample(const Image& image, int factor);

// Writes an image as a PNG file, which appears complete or not at all. Throws
// InputError if the folder cannot be written.
void WritePng(const std::string& path, const Image& image);

}  // namespace musclewarp
