// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/mujoco/skin_slides.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "musclewarp/base/random_draws.h"
#include "musclewarp/mesh/transformed.h"

namespace musclewarp {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

// A skin of two bones, of which the second turns about x by the first of two
// coordinates, and slides that carry its vertices further.
struct Example {
  explicit Example(int seed, int num_frames = 60, int num_vertices = 30) {
    RandomDraws draws(seed);
    skin.places.resize(num_vertices, 3);
    skin.weights.resize(num_vertices, 2);
    for (int v = 0; v < num_vertices; ++v) {
      for (int k = 0; k < 3; ++k) skin.places(v, k) = draws.Uniform(-50, 50);
      skin.weights(v, 0) = draws.Uniform(0, 1);
      skin.weights(v, 1) = 1 - skin.weights(v, 0);
    }
    values.resize(num_frames, 2);
    for (int f = 0; f < num_frames; ++f) {
      values.row(f) << draws.Uniform(-0.5, 1.2), draws.Uniform(0.2, 0.9);
      Eigen::Matrix4d turned = Eigen::Matrix4d::Identity();
      turned.topLeftCorner<3, 3>() =
          Eigen::AngleAxisd(values(f, 0), Vector3d::UnitX()).matrix();
      motions.push_back({Eigen::Matrix4d::Identity(), turned});
    }
  }

  // The skin in a frame, with slides on a bone.
  Points InFrame(int f, int bone, const std::vector<SkinSlide>& slides) const {
    Points points = Points::Zero(skin.places.rows(), 3);
    for (int b = 0; b < 2; ++b) {
      points += skin.weights.col(b).asDiagonal() *
                Transformed(skin.places, motions[f][b]);
    }
    for (const SkinSlide& slide : slides) {
      double amplitude = 0;
      for (int k = 4; k >= 0; --k) {
        amplitude =
            amplitude * values(f, slide.coordinate) + slide.coefficients[k];
      }
      const Vector3d along =
          motions[f][bone].topLeftCorner<3, 3>() * slide.direction;
      points += amplitude * slide.weights * along.transpose();
    }
    return points;
  }

  // Sets what the skin is fitted to, and how far it is from that.
  void CarryBy(int bone, const std::vector<SkinSlide>& slides) {
    frames.clear();
    double sum = 0;
    for (int f = 0; f < values.rows(); ++f) {
      frames.push_back(InFrame(f, bone, slides));
      sum += (frames[f] - InFrame(f, bone, {})).rowwise().norm().mean();
    }
    skin.mean_distance = sum / static_cast<double>(values.rows());
  }

  SkinSlides Fit(double max_mean) const {
    return FitSlides(skin, frames, motions, values, max_mean);
  }

  double MeanDistance(const SkinSlides& found) const {
    double sum = 0;
    for (int f = 0; f < values.rows(); ++f) {
      sum += (frames[f] - InFrame(f, found.bone, found.slides))
                 .rowwise()
                 .norm()
                 .mean();
    }
    return sum / static_cast<double>(values.rows());
  }

  SkinWeights skin;
  MatrixXd values;
  std::vector<std::vector<Eigen::Matrix4d>> motions;
  std::vector<Points> frames;
};

SkinSlide SlideOf(int coordinate,
                  const Vector3d& direction,
                  const std::array<double, 5>& coefficients,
                  int seed) {
  RandomDraws draws(seed);
  SkinSlide slide;
  slide.coordinate = coordinate;
  slide.direction = direction.normalized();
  slide.coefficients = coefficients;
  slide.weights.resize(30);
  for (double& weight : slide.weights) weight = draws.Uniform(-1, 1);
  return slide;
}

// Two slides along different directions, by different coordinates.
std::vector<SkinSlide> TwoSlides() {
  return {SlideOf(0, {1, 2, -1}, {0, 30, -8, 0, 3}, 7),
          SlideOf(1, {0, 1, 2}, {1, -15, 0, 9, 0}, 8)};
}

// Rounding of least squares of coordinates of 100 mm.
constexpr double kRounding = 1e-7;

TEST(SkinSlides, FindTheOneThatCarriedTheVertices) {
  for (const int bone : {0, 1}) {
    for (const SkinSlide& slide : TwoSlides()) {
      Example example(1);
      example.CarryBy(bone, {slide});
      const SkinSlides found = example.Fit(1e-6);
      EXPECT_EQ(found.bone, bone);
      ASSERT_EQ(found.slides.size(), 1u);
      EXPECT_EQ(found.slides[0].coordinate, slide.coordinate);
      EXPECT_NEAR(std::abs(found.slides[0].direction.dot(slide.direction)),
                  1,
                  kRounding);
      EXPECT_NEAR(found.slides[0].weights.cwiseAbs().maxCoeff(), 1, 1e-12);
      EXPECT_LT(found.largest_distance, kRounding);
      // What is written is what was fitted.
      EXPECT_LT(example.MeanDistance(found), kRounding);
    }
  }
}

TEST(SkinSlides, SeparateTwo) {
  for (const int bone : {0, 1}) {
    Example example(1);
    example.CarryBy(bone, TwoSlides());
    // They are found by turns, so that a little is left.
    const SkinSlides found = example.Fit(0.02 * example.skin.mean_distance);
    EXPECT_EQ(found.bone, bone);
    EXPECT_EQ(found.slides.size(), 2u);
    EXPECT_NEAR(example.MeanDistance(found), found.mean_distance, kRounding);
  }
}

TEST(SkinSlides, AreNoMoreThanTheBoundNeeds) {
  Example example(2);
  example.CarryBy(1, TwoSlides());
  EXPECT_EQ(example.Fit(example.skin.mean_distance).bone, -1);
  const SkinSlides found = example.Fit(0.6 * example.skin.mean_distance);
  EXPECT_EQ(found.slides.size(), 1u);
  EXPECT_LT(found.mean_distance, 0.6 * example.skin.mean_distance);
  EXPECT_NEAR(example.MeanDistance(found), found.mean_distance, kRounding);
}

TEST(SkinSlides, TurnWithTheScene) {
  Example example(3);
  example.CarryBy(1, TwoSlides());
  const double bound = 0.5 * example.skin.mean_distance;
  const SkinSlides found = example.Fit(bound);
  Eigen::Matrix4d turn = Eigen::Matrix4d::Identity();
  turn.topLeftCorner<3, 3>() =
      Eigen::AngleAxisd(0.7, Vector3d(1, -2, 3).normalized()).matrix();
  const Eigen::Matrix4d back = turn.inverse();
  example.skin.places = Transformed(example.skin.places, turn);
  for (size_t f = 0; f < example.frames.size(); ++f) {
    example.frames[f] = Transformed(example.frames[f], turn);
    for (auto& motion : example.motions[f]) motion = turn * motion * back;
  }
  const SkinSlides turned = example.Fit(bound);
  EXPECT_EQ(turned.bone, found.bone);
  ASSERT_EQ(turned.slides.size(), found.slides.size());
  EXPECT_NEAR(turned.mean_distance, found.mean_distance, kRounding);
  for (size_t k = 0; k < found.slides.size(); ++k) {
    const Vector3d expected =
        turn.topLeftCorner<3, 3>() * found.slides[k].direction;
    EXPECT_NEAR(std::abs(turned.slides[k].direction.dot(expected)), 1, 1e-7);
  }
}

TEST(SkinSlides, NeedFramesAndCoordinatesThatMove) {
  Example few(4, 4);
  few.CarryBy(1, TwoSlides());
  EXPECT_EQ(few.Fit(0.1).bone, -1);
  Example still(5);
  still.CarryBy(1, TwoSlides());
  still.values.setConstant(0.5);
  const SkinSlides found = still.Fit(0.1);
  EXPECT_EQ(found.bone, -1);
  EXPECT_EQ(found.mean_distance, still.skin.mean_distance);
}

}  // namespace
}  // namespace musclewarp
