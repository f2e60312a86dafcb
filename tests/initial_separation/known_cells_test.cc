// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/known_cells.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>

#include "musclewarp/initial_separation/initial_separation.h"
#include "support/meshes.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;

// Two pairs of balls that overlap, 200 mm apart, each beside a bone.
struct TwoPlaces {
  std::deque<SearchableMesh> meshes;

  explicit TwoPlaces(double size_of_last) {
    meshes.emplace_back(Icosphere(20, 3));
    meshes.emplace_back(MovedBy(Icosphere(20, 3), {30, 0, 0}));
    meshes.emplace_back(MovedBy(Icosphere(20, 3), {200, 0, 0}));
    meshes.emplace_back(MovedBy(Icosphere(size_of_last, 3), {230, 0, 0}));
    meshes.emplace_back(MovedBy(Box(60, 10, 60), {15, 20, 0}));
    meshes.emplace_back(MovedBy(Box(60, 10, 60), {215, 20, 0}));
  }
  std::vector<const SearchableMesh*> muscles() const {
    return {&meshes[0], &meshes[1], &meshes[2], &meshes[3]};
  }
  std::vector<const SearchableMesh*> bones() const {
    return {&meshes[4], &meshes[5]};
  }
};

TEST(KnownCells, AreThoseWithNothingNewNearby) {
  const TwoPlaces before(20), after(22);
  KnownCells known;
  EXPECT_THAT(AreStillKnown(known, before.muscles(), before.bones(), 9),
              ElementsAre(0, 0, 0, 0));
  Remember(before.muscles(), before.bones(), {{}, {}, {}, {}}, &known);
  EXPECT_THAT(AreStillKnown(known, before.muscles(), before.bones(), 9),
              ElementsAre(1, 1, 1, 1));
  EXPECT_THAT(AreStillKnown(known, after.muscles(), after.bones(), 9),
              ElementsAre(1, 1, 0, 0));
  // The first place is 158 mm from the last ball.
  EXPECT_THAT(AreStillKnown(known, after.muscles(), after.bones(), 159),
              ElementsAre(1, 0, 0, 0));
}

// A muscle that swallows another, or is swallowed, is near it.
TEST(KnownCells, AreNotThoseOfMusclesInsideAChangedOne) {
  const SearchableMesh small(Icosphere(5, 3)), large(Icosphere(40, 3)),
      larger(Icosphere(41, 3));
  KnownCells known;
  Remember({&small, &large}, {}, {{}, {}}, &known);
  EXPECT_THAT(AreStillKnown(known, {&small, &larger}, {}, 9),
              ElementsAre(0, 0));
}

// The separation is the same to the bit whether cells are known or not.
TEST(KnownCells, SaveTimeAndChangeNothing) {
  const TwoPlaces before(20), after(22);
  KnownCells cells;
  SeparateInitially(before.muscles(), before.bones(), {}, {}, {}, &cells);
  const InitialSeparation with =
      SeparateInitially(after.muscles(), after.bones(), {}, {}, {}, &cells);
  const InitialSeparation without =
      SeparateInitially(after.muscles(), after.bones(), {}, {});
  EXPECT_EQ(with.rounds, without.rounds);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(with.points[i], without.points[i]) << i;
    EXPECT_NE(with.points[i], after.muscles()[i]->points()) << i;
  }
}

}  // namespace
}  // namespace musclewarp
