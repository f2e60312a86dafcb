// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/certified_contact/vertex_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "musclewarp/certified_contact/muscle_surface.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

// The block of each vertex, every one of which must be in one block.
std::vector<int> BlockOfVertices(const VertexBlocks& blocks, int num_vertices) {
  std::vector<int> block_of(num_vertices, -1);
  for (int b = 0; b < blocks.num_blocks(); ++b) {
    for (int k = blocks.first[b]; k < blocks.first[b + 1]; ++k) {
      EXPECT_EQ(block_of[blocks.vertices[k]], -1);
      block_of[blocks.vertices[k]] = b;
    }
  }
  EXPECT_EQ(std::count(block_of.begin(), block_of.end(), -1), 0);
  return block_of;
}

std::vector<int> ColourOfBlocks(const VertexBlocks& blocks) {
  std::vector<int> colour_of(blocks.num_blocks(), -1);
  for (size_t c = 0; c < blocks.colours.size(); ++c) {
    for (const int b : blocks.colours[c]) {
      EXPECT_EQ(colour_of[b], -1);
      colour_of[b] = static_cast<int>(c);
    }
  }
  EXPECT_EQ(std::count(colour_of.begin(), colour_of.end(), -1), 0);
  return colour_of;
}

TEST(VertexBlocks, NoEdgeJoinsTwoBlocksOfOneColour) {
  const TriangleSoup sphere = Icosphere(10, 4);
  const MuscleSurface surface =
      MakeMuscleSurface(sphere.points, sphere.triangles, 1);
  for (const int largest : {1, 7, 64, 100000}) {
    const VertexBlocks blocks = MakeVertexBlocks(
        sphere.points, surface.first, surface.neighbours, largest);
    const std::vector<int> block_of =
        BlockOfVertices(blocks, surface.num_vertices());
    const std::vector<int> colour_of = ColourOfBlocks(blocks);
    for (int v = 0; v < surface.num_vertices(); ++v) {
      for (int e = surface.first[v]; e < surface.first[v + 1]; ++e) {
        const int a = block_of[v], b = block_of[surface.neighbours[e]];
        if (a != b) {
          EXPECT_NE(colour_of[a], colour_of[b]);
        }
      }
    }
    for (int b = 0; b < blocks.num_blocks(); ++b) {
      EXPECT_LE(blocks.first[b + 1] - blocks.first[b], largest);
    }
    // A planar graph needs four colours; blocks one by one take a few more.
    EXPECT_LE(blocks.colours.size(), 8u);
  }
}

TEST(VertexBlocks, HaveNeighboursTogether) {
  const TriangleSoup sphere = Icosphere(10, 4);
  const VertexBlocks blocks =
      MakeMuscleSurface(sphere.points, sphere.triangles, 1).blocks;
  const double area = 4 * 3.14 * 100 / blocks.num_blocks();
  for (int b = 0; b < blocks.num_blocks(); ++b) {
    const std::vector<int> vertices(
        blocks.vertices.begin() + blocks.first[b],
        blocks.vertices.begin() + blocks.first[b + 1]);
    const Points points = sphere.points(vertices, Eigen::all);
    EXPECT_LT(
        (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm(),
        4 * std::sqrt(area));
  }
}

TEST(VertexBlocks, OfNothingAreNone) {
  const VertexBlocks blocks = MakeVertexBlocks(Points(0, 3), {0}, {}, 64);
  EXPECT_EQ(blocks.num_blocks(), 0);
  EXPECT_TRUE(blocks.colours.empty());
}

}  // namespace
}  // namespace musclewarp
