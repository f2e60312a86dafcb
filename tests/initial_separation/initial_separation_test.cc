// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/initial_separation/initial_separation.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "support/meshes.h"

namespace musclewarp {
namespace {

using Eigen::RowVector3d;

int CrossingPairs(const SearchableMesh& a,
                  const Points& points_a,
                  const SearchableMesh& b,
                  const Points& points_b) {
  return static_cast<int>(
      IntersectingTriangles(TriangleBvh(points_a, a.triangles()),
                            TriangleBvh(points_b, b.triangles()))
          .size());
}

}  // namespace

TEST(InitialSeparation, LeavesWhatIsApart) {
  const SearchableMesh a(SphereAt({0, 0, 0}, 10, 3));
  const SearchableMesh b(SphereAt({21, 0, 0}, 10, 3));
  const SearchableMesh bone(Box(1, 1, 1));
  const InitialSeparation separation = SeparateInitially({&a, &b}, {}, {}, {});
  EXPECT_EQ(separation.rounds, 0);
  EXPECT_EQ(separation.crossing_pairs, 0);
  EXPECT_EQ(separation.points[0], a.points());
  EXPECT_EQ(separation.points[1], b.points());
}

TEST(InitialSeparation, PartsThreeMusclesOnABoneThatAreTenDeepInEachOther) {
  const SearchableMesh a(SphereAt({0, 0, 14}, 15, 4));
  const SearchableMesh b(SphereAt({20, 0, 14}, 15, 3));
  const SearchableMesh c(SphereAt({10, 17, 14}, 15, 5));  // finer by far
  const SearchableMesh bone(MovedBy(Box(80, 80, 10), {10, 6, 0}));
  const std::vector<const SearchableMesh*> muscles = {&a, &b, &c};
  ASSERT_FALSE(IntersectMeshes(a, b).IsEmpty());
  ASSERT_FALSE(IntersectMeshes(c, bone).IsEmpty());
  const InitialSeparation separation =
      SeparateInitially(muscles, {&bone}, {}, {});
  EXPECT_EQ(separation.crossing_pairs, 0);
  for (size_t i = 0; i < muscles.size(); ++i) {
    EXPECT_EQ(
        CrossingPairs(*muscles[i], separation.points[i], bone, bone.points()),
        0);
    EXPECT_GT(separation.points[i].col(2).minCoeff(), 5);
    for (size_t j = i + 1; j < muscles.size(); ++j) {
      EXPECT_EQ(CrossingPairs(*muscles[i],
                              separation.points[i],
                              *muscles[j],
                              separation.points[j]),
                0);
    }
  }
}

TEST(InitialSeparation, PutsAMuscleToTheSideOfAThinPlateWhereMostOfItIs) {
  // A plate 1 thick, that a muscle is 6 deep through.
  const SearchableMesh muscle(SphereAt({0, 0, 0}, 15, 4));
  const SearchableMesh plate(MovedBy(Box(60, 60, 1), {0, 0, -9.5}));
  const InitialSeparation separation =
      SeparateInitially({&muscle}, {&plate}, {}, {});
  EXPECT_EQ(separation.crossing_pairs, 0);
  EXPECT_GT(separation.points[0].col(2).minCoeff(), -9);
}

TEST(InitialSeparation, DoesNotDependOnTheOrderOfMuscles) {
  const SearchableMesh a(SphereAt({0, 0, 0}, 10, 3));
  const SearchableMesh b(SphereAt({14, 1, 0}, 10, 4));
  const SearchableMesh c(SphereAt({7, 12, 1}, 10, 3));
  const SearchableMesh bone(SphereAt({7, 4, -12}, 8, 3));
  const InitialSeparation one =
      SeparateInitially({&a, &b, &c}, {&bone}, {}, {});
  const InitialSeparation two =
      SeparateInitially({&c, &a, &b}, {&bone}, {}, {});
  // Sums of pushes in another order.
  EXPECT_LT((one.points[0] - two.points[1]).norm(), 1e-9);
  EXPECT_LT((one.points[1] - two.points[2]).norm(), 1e-9);
  EXPECT_LT((one.points[2] - two.points[0]).norm(), 1e-9);
  EXPECT_EQ(one.rounds, two.rounds);
}

TEST(InitialSeparation, LeavesExemptVerticesWhereTheyAre) {
  const SearchableMesh muscle(SphereAt({0, 0, 12}, 10, 3));
  const SearchableMesh bone(MovedBy(Box(40, 40, 10), {0, 0, 0}));
  ExemptArea area;
  area.muscle = 0;
  area.bone = 0;
  for (Eigen::Index v = 0; v < muscle.points().rows(); ++v) {
    area.vertices.push_back(muscle.points()(v, 2) < 6);
  }
  for (Eigen::Index f = 0; f < muscle.triangles().rows(); ++f) {
    const auto t = muscle.triangles().row(f);
    area.triangles.push_back(area.vertices[t[0]] || area.vertices[t[1]] ||
                             area.vertices[t[2]]);
  }
  const InitialSeparation separation =
      SeparateInitially({&muscle}, {&bone}, {area}, {});
  EXPECT_EQ(separation.crossing_pairs, 0);
  EXPECT_EQ(separation.points[0], muscle.points());
}

TEST(InitialSeparation, CanBeStoppedBetweenRounds) {
  const SearchableMesh a(SphereAt({0, 0, 0}, 10, 3));
  const SearchableMesh b(SphereAt({14, 1, 0}, 10, 3));
  int calls = 0;
  const auto stop = [&](int /*round*/, int /*crossing_pairs*/) {
    ++calls;
    throw std::runtime_error("stopped");
  };
  EXPECT_THROW(SeparateInitially({&a, &b}, {}, {}, {}, stop),
               std::runtime_error);
  EXPECT_EQ(calls, 1);
}

TEST(InitialSeparationOptions, NameWhatIsWrong) {
  InitialSeparationOptions options;
  std::string error;
  EXPECT_TRUE(options.IsValid(&error));
  options.step = -1;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error, "InitialSeparationOptions::step is -1, allowed: above 0");
  options = {};
  options.cell.margin = 5;
  EXPECT_FALSE(options.IsValid(&error));
  EXPECT_EQ(error, "MedialCellOptions::range is 3, allowed: above 5");
}

}  // namespace musclewarp
