// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/phantom/variation.h"

#include <gtest/gtest.h>

#include "musclewarp/mesh/measures.h"
#include "musclewarp/phantom/phantom_scene.h"
#include "musclewarp/phantom/random_scene.h"
#include "musclewarp/phantom/scene_parts.h"
#include "musclewarp/scene/line_targets.h"
#include "support/input_errors.h"

namespace musclewarp {
namespace {

double VolumeOf(const PhantomMesh& mesh) {
  return SignedVolume(mesh.surface.points, mesh.surface.triangles);
}

PhantomScene SceneWith(const Variation& variation) {
  return MakePhantomScene("random", 9, variation);
}

TEST(Variation, GivesMusclesTheirNumberOfVertices) {
  const PhantomScene drawn = SceneWith({2});
  for (const int number : {400, 4000}) {
    const PhantomScene made = SceneWith({2, number});
    for (size_t i = 0; i < made.scene.muscles.size(); ++i) {
      // Remeshing only aims at a length of edges, and thin muscles need more.
      EXPECT_GT(made.meshes[i].surface.points.rows(), 0.75 * number);
      EXPECT_LT(made.meshes[i].surface.points.rows(),
                (number < 1000 ? 2.1 : 1.25) * number);
      EXPECT_TRUE(phantom::IsSoundSurface(made.meshes[i].surface));
      // 400 vertices cut what bulges between them.
      EXPECT_NEAR(VolumeOf(made.meshes[i]),
                  VolumeOf(drawn.meshes[i]),
                  0.1 * VolumeOf(drawn.meshes[i]));
      EXPECT_EQ(made.scene.muscles[i].lines[0].rest,
                drawn.scene.muscles[i].lines[0].rest);
    }
    EXPECT_EQ(made.meshes.back().surface.points,
              drawn.meshes.back().surface.points)
        << "bones stay";
  }
}

// Whatever moves with a scene is at size * x + offset in every pose.
TEST(Variation, PlacesAllThatAPoseMoves) {
  const double size = 0.5, offset = 300;
  const PhantomScene drawn = SceneWith({2}),
                     placed = SceneWith({2, 0, 0, size, offset});
  const auto expect_placed = [&](const Points& there, const Points& here) {
    const Points expected = (size * here.array() + offset).matrix();
    // Coordinates of some 1000 mm, with rounding at each of a few steps.
    EXPECT_LT((there - expected).cwiseAbs().maxCoeff(), 1e-9);
  };
  for (size_t k = 0; k < drawn.scene.poses.size(); ++k) {
    for (size_t i = 0; i < drawn.scene.muscles.size(); ++i) {
      const auto lines = LineTargets(drawn.scene.muscles[i].lines,
                                     drawn.scene.poses[k]),
                 there = LineTargets(placed.scene.muscles[i].lines,
                                     placed.scene.poses[k]);
      expect_placed(there[0].points, lines[0].points);
    }
  }
  for (size_t i = 0; i < drawn.meshes.size(); ++i) {
    expect_placed(placed.meshes[i].delivered.points,
                  drawn.meshes[i].delivered.points);
  }
  const Attachment& attachment = drawn.scene.muscles[0].attachments[0];
  const Attachment& other = placed.scene.muscles[0].attachments[0];
  expect_placed(other.points, attachment.points);
  EXPECT_EQ(other.radius, size * attachment.radius);
}

TEST(Variation, ASceneThatIsNotDrawnHasItsOwnNumbers) {
  ExpectInputError([] { MakePhantomScene("stress_sheet", 1, {3}); },
                   {"num_muscles", "stress_sheet"});
  ExpectInputError(
      [] {
        MakePhantomScene("stress_sheet", 1, {0, 50});
      },
      {"num_vertices", "is 50"});
  ExpectInputError(
      [] {
        MakePhantomScene("hip", 1, {0, 0, 6});
      },
      {"num_poses", "hip"});
}

TEST(Variation, ASceneWithAModelKeepsItsPlace) {
  ExpectInputError(
      [] {
        MakePhantomScene("hip", 1, {0, 0, 0, 2});
      },
      {"hip", "size", "model"});
}

}  // namespace
}  // namespace musclewarp
