// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/render/picture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "musclewarp/base/input_error.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

constexpr Color kWhite{255, 255, 255};
constexpr Color kRed{200, 40, 40};
constexpr Color kBlue{40, 40, 200};

PictureMesh Sphere(double radius, double y, const Color& color) {
  PictureMesh mesh;
  mesh.surface = Icosphere(radius, 3);
  mesh.surface.points.col(1).array() += y;
  mesh.color = color;
  return mesh;
}

PictureOptions SmallPicture() {
  PictureOptions options;
  options.width = 120;
  options.height = 80;
  return options;
}

int CountInk(const Image& image, int x_begin, int x_end) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = x_begin; x < x_end; ++x) count += image.At(x, y) != kWhite;
  }
  return count;
}

// Draws from the front; the y axis points away from the viewer.
class PictureTest : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      Draw({{"", {Sphere(1, 0, kRed)}}}, SmallPicture());
    } catch (const InputError& error) {
      GTEST_SKIP() << error.what();
    }
  }

  static Image Draw(const std::vector<PicturePanel>& panels,
                    const PictureOptions& options) {
    return DrawPicture(
        panels, {-Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ()}, options);
  }
};

TEST_F(PictureTest, ASphereIsADiscOnWhite) {
  const Image image = Draw({{"", {Sphere(1, 0, kRed)}}}, SmallPicture());
  ASSERT_EQ(image.width, 120);
  ASSERT_EQ(image.height, 80);
  EXPECT_EQ(image.At(0, 0), kWhite);
  EXPECT_EQ(image.At(119, 79), kWhite);
  EXPECT_GT(image.At(60, 40).r, 2 * image.At(60, 40).b);
  // The disc nearly fills the height; a rim of one pixel may be half covered.
  const double area = CountInk(image, 0, 120);
  EXPECT_GT(area, 3.14 * 36 * 36);
  EXPECT_LT(area, 3.15 * 40 * 40);
}

TEST_F(PictureTest, TrianglesHaveTheirOwnColoursIfTheyAreGiven) {
  PictureMesh sphere = Sphere(1, 0, kRed);
  const TriangleSoup& surface = sphere.surface;
  for (Eigen::Index f = 0; f < surface.triangles.rows(); ++f) {
    const bool is_left = surface.points(surface.triangles(f, 0), 0) < 0;
    sphere.triangle_colors.push_back(is_left ? Color{0, 0, 255} : kRed);
  }
  const Image image = Draw({{"", {sphere}}}, SmallPicture());
  EXPECT_GT(image.At(45, 40).b, 2 * image.At(45, 40).r);
  EXPECT_GT(image.At(75, 40).r, 2 * image.At(75, 40).b);
}

TEST_F(PictureTest, TheNearerMeshHidesTheOther) {
  const Image image =
      Draw({{"", {Sphere(1, 2, kBlue), Sphere(1, -2, kRed)}}}, SmallPicture());
  EXPECT_GT(image.At(60, 40).r, image.At(60, 40).b);
}

TEST_F(PictureTest, AFadedMeshShowsWhatIsBehind) {
  PictureMesh front = Sphere(1, -2, kRed);
  front.opacity = 0.2;
  const Image image =
      Draw({{"", {Sphere(1, 2, kBlue), front}}}, SmallPicture());
  EXPECT_GT(image.At(60, 40).b, image.At(60, 40).r);
  front.opacity = 0;
  EXPECT_EQ(CountInk(Draw({{"", {front}}}, SmallPicture()), 0, 120), 0);
}

TEST_F(PictureTest, PanelsShareOneScale) {
  const Image image = Draw(
      {{"", {Sphere(1, 0, kRed)}}, {"", {Sphere(2, 0, kRed)}}}, SmallPicture());
  // Areas are as 1 to 4; rims of half covered pixels count as whole ones.
  const double ratio =
      static_cast<double>(CountInk(image, 60, 120)) / CountInk(image, 0, 60);
  EXPECT_NEAR(ratio, 4, 0.4);
}

TEST_F(PictureTest, TextsStandBelowTheScenes) {
  PictureOptions options = SmallPicture();
  options.width = 240;
  options.height = 160;
  const Image plain = Draw({{"", {Sphere(1, 0, kRed)}}}, options);
  options.legend = {{"ball", kBlue}};
  const Image texts = Draw({{"rest", {Sphere(1, 0, kRed)}}}, options);
  const auto is_blue = [](const Color& color) { return color == kBlue; };
  EXPECT_EQ(std::count_if(plain.pixels.begin(), plain.pixels.end(), is_blue),
            0);
  const auto first =
      std::find_if(texts.pixels.begin(), texts.pixels.end(), is_blue);
  ASSERT_NE(first, texts.pixels.end());
  EXPECT_GT(first - texts.pixels.begin(), 240 * 120);
  EXPECT_LT(CountInk(texts, 80, 160), CountInk(plain, 80, 160));
}

TEST_F(PictureTest, TheSameTwiceIsTheSame) {
  const std::vector<PicturePanel> panels = {{"a", {Sphere(1, 0, kRed)}}};
  EXPECT_EQ(Draw(panels, SmallPicture()).pixels,
            Draw(panels, SmallPicture()).pixels);
}

}  // namespace
}  // namespace musclewarp
