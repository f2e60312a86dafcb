// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/scene/attachments_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using Attachments = std::map<std::string, std::vector<Attachment>>;

// Reads a file whose areas under "muscles" are `muscles`, as JSON.
Attachments AttachmentsOf(const std::string& muscles,
                          const std::string& units = "mm") {
  const std::string path = TestTempDir() + "/areas.json";
  WriteTextAtomically(path,
                      "{\"units\": \"" + units + "\", \"muscles\": " + muscles +
                          ", \"source\": \"somebody\"}");
  return ReadAttachmentsFile(
      path, {{"origin", "pelvis"}, {"insertion", "femur"}}, 7);
}

TEST(AttachmentsFile, GivesTheAreasOfEveryMuscleToTheirBodies) {
  const Attachments attachments = AttachmentsOf(R"({
      "iliacus": {"origin": [{"set": "A", "points": [[1,2,3]]},
                             {"set": "B", "points": [[4,5,6], [7,8,9]]}],
                  "insertion": [{"points": [[0,0,1]]}]},
      "psoas": {"insertion": [{"points": [[0,0,2]]}]}})");
  ASSERT_EQ(attachments.size(), 2u);
  const auto& iliacus = attachments.at("iliacus");
  ASSERT_EQ(iliacus.size(), 3u);
  EXPECT_EQ(iliacus[0].body, "femur");  // in the order of the keys' names
  EXPECT_EQ(iliacus[2].body, "pelvis");
  EXPECT_EQ(iliacus[2].points.row(1), Eigen::RowVector3d(7, 8, 9));
  for (const Attachment& attachment : iliacus) {
    EXPECT_EQ(attachment.radius, 7);
    EXPECT_FALSE(attachment.may_penetrate);
  }
  EXPECT_EQ(attachments.at("psoas").size(), 1u);
}

TEST(AttachmentsFile, PassesOverKeysThatNoBodyIsGivenFor) {
  EXPECT_TRUE(AttachmentsOf(R"({"iliacus": {"belly": [{"points": [[1,2,3]]}],
                                   "note": 5}})")
                  .empty());
}

TEST(AttachmentsFile, RefusesWhatIsNoArea) {
  ExpectInputError([] { AttachmentsOf("{}", "inch"); },
                   {"areas.json: units", "inch", "mm, cm, m"});
  ExpectInputError([] { AttachmentsOf("[]"); },
                   {"areas.json: muscles", "object"});
  ExpectInputError(
      [] { AttachmentsOf(R"({"m": {"origin": [{"points": []}]}})"); },
      {"areas.json: muscles.m.origin[0].points", "empty", "at least one"});
  ExpectInputError(
      [] {
        AttachmentsOf(R"({"m": {"origin": [{"points": [[0, 0, 1e9]]}]}})");
      },
      {"muscles.m.origin[0].points[0][2]", "1000000000.0", "1e7"});
}

}  // namespace
}  // namespace musclewarp
