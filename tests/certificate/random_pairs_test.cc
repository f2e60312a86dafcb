// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>

#include "certificate/exact_meshes.h"
#include "certificate/mesh_pairs.h"
#include "musclewarp/base/threads.h"
#include "musclewarp/certificate/scene_intersections.h"

namespace musclewarp {
namespace {

// Compares what the certificate says of a pair with exact arithmetic.
void ExpectExact(const MeshPair& pair, const ExactPair& exact, bool b_is_bone) {
  const SearchableMesh a(pair.a), b(pair.b);
  std::vector<NamedMesh> muscles = {{"a", &a}}, bones;
  (b_is_bone ? bones : muscles).push_back({"b", &b});
  const SceneIntersections found = IntersectScene(muscles, bones);
  EXPECT_EQ(found.triangle_pairs, exact.triangle_pairs);
  EXPECT_EQ(found.vertices_inside, exact.inside);
  EXPECT_EQ(found.IsClean(), exact.triangle_pairs == 0 && exact.inside == 0);
  if (!found.IsClean()) return;
  const MeshNumber limit = kMeshGapLimit;
  if (found.gaps.empty()) {
    EXPECT_GT(exact.squared_distance, limit * limit);
    return;
  }
  ASSERT_EQ(found.gaps.size(), 1u);
  const MeshNumber least = found.gaps[0].at_least_mm;
  const MeshNumber most = found.gaps[0].at_most_mm;
  EXPECT_GE(least, 0);
  EXPECT_LE(least * least, exact.squared_distance);
  EXPECT_GE(most * most, exact.squared_distance);
}

// 500 pairs; MUSCLEWARP_PAIRS sets another number, and MUSCLEWARP_FIRST_PAIR
// the first.
int NumberFrom(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text ? std::atoi(text) : otherwise;
}

TEST(RandomPairs, AreAsExactArithmeticHasThem) {
  // Threads that wait for such small meshes take more time than they save.
  SetNumThreads(1);
  const int count = NumberFrom("MUSCLEWARP_PAIRS", 500);
  const int first = NumberFrom("MUSCLEWARP_FIRST_PAIR", 1);
  std::map<std::string, int> kinds;
  int crossing = 0, clean = 0;
  for (int seed = first; seed < first + count; ++seed) {
    const MeshPair pair = RandomMeshPair(static_cast<unsigned>(seed));
    const std::optional<ExactPair> exact = CompareExactly(pair.a, pair.b);
    if (!exact) continue;
    SCOPED_TRACE("pair " + std::to_string(seed) + ": " + pair.kind);
    ExpectExact(pair, *exact, seed % 2 == 0);
    ++kinds[pair.kind];
    crossing += exact->triangle_pairs > 0;
    clean += exact->triangle_pairs == 0 && exact->inside == 0;
  }
  // Every kind and both answers are among them.
  EXPECT_EQ(kinds.size(), 14u);
  EXPECT_GT(std::min(crossing, clean), count / 10);
  for (const auto& [kind, number] : kinds) {
    RecordProperty(kind, number);
  }
}

}  // namespace
}  // namespace musclewarp
