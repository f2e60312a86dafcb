// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/posture_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "musclewarp/scene/posture_samples.h"

namespace musclewarp {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAreArray;

const Eigen::RowVector3d kRest(0.2, 0.5, 0.4);

Eigen::RowVectorXd PlaceOf(const PostureTree& tree,
                           const Eigen::MatrixXd& postures,
                           int visit) {
  if (visit < 0) return kRest;
  return postures.row(tree.order[visit]);
}

TEST(PostureTree, VisitsEveryPostureOnceAfterItsPredecessor) {
  const Eigen::MatrixXd postures = LatinHypercube(300, 3, 1);
  const PostureTree tree = TreeFrom(kRest, postures);
  std::vector<int> all(300);
  std::iota(all.begin(), all.end(), 0);
  EXPECT_THAT(tree.order, UnorderedElementsAreArray(all));
  for (int i = 0; i < 300; ++i) {
    EXPECT_GE(tree.reached_from[i], -1);
    EXPECT_LT(tree.reached_from[i], i);
  }
}

TEST(PostureTree, ReachesEachFromTheNearestThatIsNearerToRest) {
  const Eigen::MatrixXd postures = LatinHypercube(100, 3, 2);
  const PostureTree tree = TreeFrom(kRest, postures);
  for (int i = 0; i < 100; ++i) {
    const Eigen::RowVectorXd here = PlaceOf(tree, postures, i);
    const double move =
        (here - PlaceOf(tree, postures, tree.reached_from[i])).norm();
    const double way = (here - kRest).norm();
    for (int j = -1; j < 100; ++j) {
      const Eigen::RowVectorXd other = PlaceOf(tree, postures, j);
      if ((other - kRest).norm() >= way) continue;
      EXPECT_LE(move, (here - other).norm());
    }
  }
}

TEST(PostureTree, VisitsBranchesWithoutGaps) {
  const PostureTree tree = TreeFrom(kRest, LatinHypercube(200, 3, 3));
  // What is reached from a posture in the end follows it at once.
  for (int root = 0; root < 200; ++root) {
    bool has_ended = false;
    for (int i = root + 1; i < 200; ++i) {
      int before = i;
      while (before > root) before = tree.reached_from[before];
      if (before != root) has_ended = true;
      EXPECT_FALSE(has_ended && before == root) << i << " of " << root;
    }
  }
}

TEST(PostureTree, HasShortWays) {
  // Eight postures along each side of the cube: the way to a corner leads over
  // some of them, not over hundreds.
  const PostureTree tree = TreeFrom(kRest, LatinHypercube(512, 3, 4));
  int longest = 0;
  for (int i = 0; i < 512; ++i) {
    int length = 0;
    for (int k = i; k >= 0; k = tree.reached_from[k]) ++length;
    longest = std::max(longest, length);
  }
  EXPECT_LE(longest, 24);
}

TEST(PostureTree, GoesOutwardsOnALine) {
  Eigen::MatrixXd postures(4, 3);
  postures << 0.2, 0.5, 1.0,  //
      0.2, 0.5, 0.6,          //
      0.2, 0.5, 0.1,          //
      0.2, 0.5, 0.4;          // rest itself
  const PostureTree tree = TreeFrom(kRest, postures);
  EXPECT_THAT(tree.order, ElementsAre(1, 0, 2, 3));
  EXPECT_THAT(tree.reached_from, ElementsAre(-1, 0, -1, -1));
}

}  // namespace
}  // namespace musclewarp
