// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace musclewarp {

// An RGB colour, 0 to 255.
struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
};

inline bool operator==(const Color& a, const Color& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b;
}
inline bool operator!=(const Color& a, const Color& b) { return !(a == b); }

// Pixels in rows from the top left.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Color> pixels;

  const Color& At(int x, int y) const { return pixels[y * width + x]; }
  Color& At(int x, int y) { return pixels[y * width + x]; }
};

// Averages blocks of factor x factor pixels. Precondition: factor divides
// width and height.
Image Downsample(const Image& image, int factor);

// The file appears complete or not at all. Throws InputError if the folder
// cannot be written.
void WritePng(const std::string& path, const Image& image);

}  // namespace musclewarp
