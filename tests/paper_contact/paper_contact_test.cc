// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/paper_contact/paper_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "support/meshes.h"

namespace musclewarp {
namespace {

// Shapes live as long as the contact.
struct TouchingShapes {
  TouchingShapes(const std::vector<TriangleSoup>& muscles,
                 const std::vector<TriangleSoup>& bones) {
    std::vector<ContactBody> muscle_bodies, bone_bodies;
    for (const TriangleSoup& soup : muscles) {
      shapes.push_back(std::make_unique<ContactShape>("muscle", soup, 1));
      muscle_bodies.push_back(ContactBody::Deformable(*shapes.back(), 1));
    }
    for (const TriangleSoup& soup : bones) {
      shapes.push_back(std::make_unique<ContactShape>("bone", soup, 1));
      bone_bodies.push_back(
          ContactBody::Obstacle(*shapes.back(), Eigen::Matrix4d::Identity()));
    }
    contact = std::make_unique<PaperContact>(PaperContactOptions(),
                                             std::move(muscle_bodies),
                                             std::move(bone_bodies));
  }
  std::vector<Points> AllPoints() const {
    std::vector<Points> points;
    for (int i = 0; i < contact->num_muscles(); ++i) {
      points.push_back(contact->muscle(i).points());
    }
    return points;
  }
  std::vector<std::unique_ptr<ContactShape>> shapes;
  std::unique_ptr<PaperContact> contact;
};

TriangleSoup Ball(double x) { return MovedBy(Icosphere(10, 2), {x, 0, 0}); }

// The number of vertices of all bodies inside another one.
int VerticesInside(const TouchingShapes& scene) {
  int inside = 0;
  const auto count = [&](const ContactBody& a, const ContactBody& b) {
    inside += static_cast<int>(b.Inside(a.points()).size() +
                               a.Inside(b.points()).size());
  };
  for (int i = 0; i < scene.contact->num_muscles(); ++i) {
    const ContactBody& muscle = scene.contact->muscle(i);
    for (int j = i + 1; j < scene.contact->num_muscles(); ++j) {
      count(muscle, scene.contact->muscle(j));
    }
    for (int j = 0; j < scene.contact->num_bones(); ++j) {
      count(muscle, scene.contact->bone(j));
    }
  }
  return inside;
}

void ExpectThatBonesStayed(const TouchingShapes& scene) {
  for (int j = 0; j < scene.contact->num_bones(); ++j) {
    const ContactBody& bone = scene.contact->bone(j);
    EXPECT_EQ(bone.points(), bone.shape().rest);
  }
}

// Expects that the final fix leaves nothing inside after a few rounds, and has
// nothing more to do then.
void ExpectThatTheFinalFixParts(TouchingShapes* scene) {
  constexpr int kMaxRounds = 40;  // as many as GroupContact takes
  int round = 0;
  while (round < kMaxRounds && scene->contact->FixRemaining()) ++round;
  EXPECT_LT(round, kMaxRounds);
  EXPECT_EQ(VerticesInside(*scene), 0);
  ExpectThatBonesStayed(*scene);
  const std::vector<Points> parted = scene->AllPoints();
  EXPECT_FALSE(scene->contact->FixRemaining());
  EXPECT_EQ(scene->AllPoints(), parted);
}

// Steps all muscles along x and expects the laws of the rollback, whatever is
// inside what: a vertex that was found inside stays on the line of its step,
// near it, and all others stay where the step took them.
void ExpectALawfulStep(TouchingShapes* scene) {
  constexpr double kStep = 0.1;
  const std::vector<Points> before = scene->AllPoints();
  std::vector<Points> stepped = before;
  for (int i = 0; i < scene->contact->num_muscles(); ++i) {
    stepped[i].col(0).array() += kStep;
    scene->contact->MoveMuscle(i, stepped[i]);
  }
  scene->contact->RollBack(before);
  // Every other body may send a vertex back by the longest steps of both.
  const int others =
      scene->contact->num_muscles() + scene->contact->num_bones() - 1;
  const double reach = others * (2 * kStep + PaperContactOptions().clearance);
  for (int i = 0; i < scene->contact->num_muscles(); ++i) {
    const Points& after = scene->contact->muscle(i).points();
    for (Eigen::Index v = 0; v < after.rows(); ++v) {
      const Eigen::RowVector3d move = after.row(v) - stepped[i].row(v);
      EXPECT_EQ(move.tail<2>().norm(), 0);
      EXPECT_LE(move.norm(), scene->contact->found_inside()[i][v] ? reach : 0);
    }
  }
  ExpectThatBonesStayed(*scene);
}

}  // namespace

TEST(PaperContact, LeavesWhatIsApart) {
  TouchingShapes scene({Ball(0), Ball(30)}, {Ball(60)});
  const auto before = scene.AllPoints();
  EXPECT_FALSE(scene.contact->FixInitial());
  scene.contact->RollBack(before);
  EXPECT_FALSE(scene.contact->FixRemaining());
  EXPECT_EQ(scene.AllPoints(), before);
}

TEST(PaperContact, LaterPairsSeeWhatEarlierOnesDid) {
  // Three in a row: the one in the middle gives way to both.
  TouchingShapes together({Ball(0), Ball(18), Ball(36)}, {});
  EXPECT_TRUE(together.contact->FixInitial());
  TouchingShapes first({Ball(0), Ball(18)}, {});
  EXPECT_TRUE(first.contact->FixInitial());
  EXPECT_EQ(together.AllPoints()[0], first.AllPoints()[0]);
  EXPECT_NE(together.AllPoints()[1], first.AllPoints()[1]);
  TouchingShapes second({MovedBy(Ball(18), {0, 0, 0}), Ball(36)}, {});
  second.contact->MoveMuscle(0, first.AllPoints()[1]);
  EXPECT_TRUE(second.contact->FixInitial());
  EXPECT_EQ(together.AllPoints()[1], second.AllPoints()[0]);
  EXPECT_EQ(together.AllPoints()[2], second.AllPoints()[1]);
}

TEST(PaperContact, SaysWhichVerticesItFound) {
  TouchingShapes scene({Ball(0), Ball(40)}, {Ball(21)});
  const auto before = scene.AllPoints();
  scene.contact->MoveMuscle(0,
                            before[0].rowwise() + Eigen::RowVector3d(2, 0, 0));
  const auto inside =
      ContactBody::Obstacle(*scene.shapes[2], Eigen::Matrix4d::Identity())
          .Inside(scene.AllPoints()[0]);
  ASSERT_FALSE(inside.empty());
  scene.contact->RollBack(before);
  std::vector<int> found;
  for (size_t v = 0; v < scene.contact->found_inside()[0].size(); ++v) {
    if (scene.contact->found_inside()[0][v]) found.push_back(v);
  }
  EXPECT_EQ(found, inside);
  const auto& other = scene.contact->found_inside()[1];
  // The second muscle overlaps the bone at rest, but did not step.
  EXPECT_EQ(scene.AllPoints()[1], before[1]);
  EXPECT_GT(std::count(other.begin(), other.end(), 1), 0);
}

// No vertex of the muscle is inside the bone, and no triangle near enough to be
// pushed off it.
TEST(PaperContact, LeavesABoneDeepInsideAMuscle) {
  TouchingShapes scene({Ball(0)}, {Icosphere(3, 1)});
  const std::vector<Points> start = scene.AllPoints();
  EXPECT_TRUE(scene.contact->FixInitial());
  EXPECT_TRUE(scene.contact->FixRemaining());
  EXPECT_EQ(scene.AllPoints(), start);
  ExpectALawfulStep(&scene);
}

TEST(PaperContact, TakesAMuscleOutOfAnother) {
  TouchingShapes scene({Ball(0), Icosphere(3, 2)}, {});
  ASSERT_EQ(VerticesInside(scene), 162);
  EXPECT_TRUE(scene.contact->FixInitial());
  ExpectALawfulStep(&scene);
  ExpectThatTheFinalFixParts(&scene);
}

TEST(PaperContact, TakesAMuscleOutOfABone) {
  TouchingShapes scene({Icosphere(3, 2)}, {Ball(0)});
  ASSERT_EQ(VerticesInside(scene), 162);
  EXPECT_TRUE(scene.contact->FixInitial());
  ExpectALawfulStep(&scene);
  ExpectThatTheFinalFixParts(&scene);
}

TEST(PaperContact, IdenticalMeshesHaveNothingInside) {
  TouchingShapes scene({Ball(0), Ball(0)}, {Ball(0)});
  const std::vector<Points> start = scene.AllPoints();
  EXPECT_FALSE(scene.contact->FixInitial());
  EXPECT_FALSE(scene.contact->FixRemaining());
  EXPECT_EQ(scene.AllPoints(), start);
  ExpectALawfulStep(&scene);
}

TEST(PaperContact, PartsAMuscleFromAnObstacleThatIsNotClosed) {
  TriangleSoup open = Ball(15);
  open.triangles = open.triangles.topRows(300).eval();
  TouchingShapes scene({Ball(0)}, {open});
  EXPECT_TRUE(scene.contact->FixInitial());
  ExpectALawfulStep(&scene);
  ExpectThatTheFinalFixParts(&scene);
}

TEST(PaperContact, MovesOnlyWhatIsInsideAndNoFartherThanItIsDeep) {
  TouchingShapes scene({Ball(0), Ball(18)}, {});
  const std::vector<Points> start = scene.AllPoints();
  std::vector<std::vector<int>> inside;
  for (int i = 0; i < 2; ++i) {
    inside.push_back(scene.contact->muscle(1 - i).Inside(start[i]));
    ASSERT_FALSE(inside[i].empty());
  }
  scene.contact->FixInitial();
  // Balls of radius 10 whose centres are 18 apart are 2 deep in each other.
  // Their regions are too far apart to be paired, and go all the way.
  const double farthest = 2 + PaperContactOptions().clearance + 1e-12;
  for (int i = 0; i < 2; ++i) {
    const Points moves = scene.AllPoints()[i] - start[i];
    for (int v = 0; v < moves.rows(); ++v) {
      if (std::binary_search(inside[i].begin(), inside[i].end(), v)) {
        EXPECT_GT(moves.row(v).norm(), 0);
        EXPECT_LE(moves.row(v).norm(), farthest);
      } else {
        EXPECT_EQ(moves.row(v).norm(), 0);
      }
    }
  }
  ExpectThatTheFinalFixParts(&scene);
}

// A bone that moves through a standing muscle: seen from the bone the muscle
// came to it, so its vertices go out on the side they were on.
TEST(PaperContact, MovedBonesPushVerticesAheadOfThem) {
  // The bone stood 12 mm to the left and has come into the ball.
  TouchingShapes scene({Ball(0)}, {Ball(-14)});
  Eigen::Matrix4d now_from_before = Eigen::Matrix4d::Identity();
  now_from_before(0, 3) = 12;
  const std::vector<Points> before = scene.AllPoints();
  scene.contact->RollBack(before, {now_from_before});
  const Points& after = scene.contact->muscle(0).points();
  int moved = 0;
  for (Eigen::Index v = 0; v < after.rows(); ++v) {
    const Eigen::RowVector3d move = after.row(v) - before[0].row(v);
    if (move.norm() == 0) continue;
    ++moved;
    // Along the way of the bone, and no farther.
    EXPECT_GT(move[0], 0);
    EXPECT_LT(move.tail<2>().norm(), 1e-12);
    EXPECT_LT(move[0], 12.01);
    EXPECT_TRUE(scene.contact->found_inside()[0][v]);
  }
  EXPECT_GT(moved, 5);
  const ContactShape bone("bone", Ball(-14), 1);
  EXPECT_TRUE(ContactBody::Obstacle(bone, Eigen::Matrix4d::Identity())
                  .Inside(after)
                  .empty());
}

}  // namespace musclewarp
