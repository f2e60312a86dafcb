// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/base/palette.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace musclewarp {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// IEC 61966-2-1.
double LinearFromSrgb(std::uint8_t value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

// CIE 1976 L*a*b*, white point D65.
Vector3d LabFromLinear(const Vector3d& rgb) {
  Matrix3d xyz_from_rgb;
  xyz_from_rgb << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193,
      0.1192, 0.9505;
  const Vector3d xyz =
      (xyz_from_rgb * rgb).cwiseQuotient(Vector3d(0.9505, 1, 1.089));
  const Vector3d f = xyz.unaryExpr([](double t) {
    return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116;
  });
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

// Usual vision, and what is seen without red, green, blue cones: Machado,
// Oliveira, Fernandes, "A Physiologically-based Model for Simulation of Color
// Vision Deficiency", 2009, severity 1.
std::vector<Matrix3d> Visions() {
  std::vector<Matrix3d> visions(4, Matrix3d::Identity());
  visions[1] << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216,
      -0.003882, -0.048116, 1.051998;
  visions[2] << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413,
      -0.011820, 0.042940, 0.968881;
  visions[3] << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602,
      0.004733, 0.691367, 0.303900;
  return visions;
}

Vector3d Seen(const Color& color, const Matrix3d& vision) {
  const Vector3d rgb(LinearFromSrgb(color.r),
                     LinearFromSrgb(color.g),
                     LinearFromSrgb(color.b));
  return LabFromLinear((vision * rgb).cwiseMax(0.0).cwiseMin(1.0));
}

TEST(Palette, ColorsStayApartForTheColorBlind) {
  // A difference of 2.3 is just noticed side by side; shading asks for more.
  constexpr double kFarApart = 14;
  std::vector<Color> colors = {BoneColor()};
  for (int i = 0; i < kMuscleColors; ++i) colors.push_back(MuscleColor(i));
  for (const Matrix3d& vision : Visions()) {
    for (std::size_t i = 0; i < colors.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_GT((Seen(colors[i], vision) - Seen(colors[j], vision)).norm(),
                  kFarApart)
            << "colors " << i << " and " << j;
      }
    }
  }
}

TEST(Palette, StartsAgainAfterTheLastColor) {
  EXPECT_EQ(MuscleColor(kMuscleColors), MuscleColor(0));
}

}  // namespace
}  // namespace musclewarp
