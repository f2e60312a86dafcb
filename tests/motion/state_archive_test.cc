// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/motion/state_archive.h"

#include <gmock/gmock.h>

#include <cereal/archives/binary.hpp>
#include <sstream>
#include <string>

namespace musclewarp {

// One struct before and after two of its fields swapped places.
namespace before {
struct Ends {
  double first = 1, last = 2;
};
MUSCLEWARP_ARCHIVE(Ends, first, last)
}  // namespace before
namespace after {
struct Ends {
  double last = 0, first = 0;
};
MUSCLEWARP_ARCHIVE(Ends, first, last)
}  // namespace after

namespace {

using ::testing::HasSubstr;

TEST(ArchivedFields, FieldsThatSwapPlacesKeepTheirValues) {
  std::stringstream stream;
  before::Ends written;
  cereal::BinaryOutputArchive output(stream);
  output(written);
  after::Ends read;
  cereal::BinaryInputArchive input(stream);
  input(read);
  EXPECT_EQ(read.first, written.first);
  EXPECT_EQ(read.last, written.last);
}

// A file states the names and types of what it holds, in their order.
TEST(ArchivedFields, AreNamedWithTheirTypes) {
  const std::string space = std::string("HalfSpace\n  normal ") +
                            typeid(Eigen::RowVector3d).name() + "\n  level " +
                            typeid(double).name();
  EXPECT_THAT(ArchivedFields(), HasSubstr(space));
}

// A state is that of a motion, which goes on as if it had not been written.
TEST(StateArchive, GivesAStateBackToTheLastBit) {
  ContactState contact;
  contact.pose.name = "flexed";
  contact.pose.time = 0.1;
  contact.pose.bodies["femur"] = Eigen::Matrix4d::Identity() / 3;
  contact.bones_from_rest = {contact.pose.bodies["femur"]};
  contact.free_coarse = {Points::Random(4, 3)};
  contact.coarse = {Points::Random(4, 3)};
  contact.targets = {Points::Random(7, 3)};
  contact.points = {Points::Random(7, 3)};
  contact.held = {{{2, 5}, Points::Random(2, 3)}};
  PlaneOwner owner;
  owner.muscle_above = owner.muscle_below = 0;
  owner.above = {1, 2, 3};
  owner.below = {4, 5, 6};
  contact.planes = {{{{3, {{0, 0.6, 0.8}, 1.5}}}, {owner}}};
  KeptPlanes kept;
  kept.triangles = {{7, Corners::Random(), 1.25, 0, 1}};
  kept.spaces = {{{0, 0.8, 0.6}, 2.5}};
  kept.clearances.distances = {3};
  contact.bone_planes =
      std::make_shared<const KeptBonePlanes>(KeptBonePlanes{kept});
  SceneState written;
  written.pose = contact.pose;
  written.contact = contact;
  std::stringstream stream;
  cereal::BinaryOutputArchive output(stream);
  output(written);
  SceneState read;
  cereal::BinaryInputArchive input(stream);
  input(read);
  ASSERT_TRUE(read.contact.has_value());
  EXPECT_EQ(read.pose.name, "flexed");
  EXPECT_EQ(read.contact->pose.time, 0.1);
  EXPECT_EQ(read.contact->pose.bodies, contact.pose.bodies);
  EXPECT_EQ(read.contact->bones_from_rest, contact.bones_from_rest);
  EXPECT_EQ(read.contact->free_coarse, contact.free_coarse);
  EXPECT_EQ(read.contact->coarse, contact.coarse);
  EXPECT_EQ(read.contact->targets, contact.targets);
  EXPECT_EQ(read.contact->points, contact.points);
  EXPECT_EQ(read.contact->held[0].vertices, contact.held[0].vertices);
  EXPECT_EQ(read.contact->held[0].positions, contact.held[0].positions);
  const OwnedHalfSpaces& planes = read.contact->planes[0];
  EXPECT_EQ(planes.spaces[0].vertex, 3);
  EXPECT_EQ(planes.spaces[0].space.normal, Eigen::RowVector3d(0, 0.6, 0.8));
  EXPECT_EQ(planes.spaces[0].space.level, 1.5);
  EXPECT_EQ(planes.owners[0].above, owner.above);
  EXPECT_EQ(planes.owners[0].share_above, owner.share_above);
  ASSERT_NE(read.contact->bone_planes, nullptr);
  const KeptPlanes& kept_read = read.contact->bone_planes->at(0);
  ASSERT_EQ(kept_read.triangles.size(), 1u);
  EXPECT_EQ(kept_read.triangles[0].triangle, 7);
  EXPECT_EQ(kept_read.triangles[0].corners, kept.triangles[0].corners);
  EXPECT_EQ(kept_read.triangles[0].radius, 1.25);
  EXPECT_EQ(kept_read.triangles[0].num_spaces, 1);
  EXPECT_EQ(kept_read.spaces.at(0).normal, kept.spaces[0].normal);
  EXPECT_EQ(kept_read.spaces.at(0).level, 2.5);
  EXPECT_TRUE(kept_read.clearances.distances.empty());
}

}  // namespace
}  // namespace musclewarp
