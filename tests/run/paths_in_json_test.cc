// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/run/paths_in_json.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "musclewarp/base/output_file.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

using OrderedJson = nlohmann::ordered_json;

// What a report says of a mesh in the folder `data`.
OrderedJson ReportOn(const std::string& data) {
  return {{"command", "musclewarp-deform --scene=" + data + "/bone.ply"},
          {"options", {{"scene", data + "/bone.ply"}, {"gap", "0.1"}}},
          {"prepare",
           {{"bones", {{{"name", data}, {"mesh", data + "/bone.ply"}}}},
            {"warnings", {data + "/bone.ply: is open"}}}},
          {"frames", {{{"name", data}, {"shortcomings", {data + ": lost"}}}}}};
}

TEST(PathsInJson, LeadFromTheFolderOfTheFile) {
  const std::string dir = TestTempDir();
  std::filesystem::create_directories(dir + "/data");
  std::filesystem::create_directories(dir + "/run");
  WriteTextAtomically(dir + "/data/bone.ply", "");
  OrderedJson report = ReportOn(dir + "/data");
  AdaptTexts(dir + "/run", &report);
  OrderedJson expected = ReportOn("../data");
  // Names are no paths, whatever they are.
  expected["prepare"]["bones"][0]["name"] = dir + "/data";
  expected["frames"][0]["name"] = dir + "/data";
  EXPECT_EQ(report, expected);
}

TEST(PathsInJson, MayNameAPartOfAFile) {
  const std::string dir = TestTempDir();
  std::filesystem::create_directories(dir + "/run");
  WriteTextAtomically(dir + "/two.obj", "");
  OrderedJson report = {{"mesh", dir + "/two.obj#left psoas"}};
  AdaptTexts(dir + "/run", &report);
  EXPECT_EQ(report["mesh"], "../two.obj#left psoas");
}

TEST(PathsInJson, NameSettingsAsFlagsInTextsAlone) {
  OrderedJson report = {{"notes", {"a: is open ({max_hole})"}},
                        {"name", "{max_hole}"}};
  AdaptTexts(TestTempDir(), &report);
  EXPECT_EQ(report["notes"][0], "a: is open (--max_hole)");
  EXPECT_EQ(report["name"], "{max_hole}");
}

TEST(PathsInJson, ShowNoFoldersOfTheMachine) {
  OrderedJson report = ReportOn("/home/anna/data");
  RemoveFolders(&report);
  EXPECT_EQ(report["command"], "musclewarp-deform --scene=bone.ply");
  EXPECT_EQ(report["options"]["scene"], "bone.ply");
  EXPECT_EQ(report["options"]["gap"], "0.1");
  EXPECT_EQ(report["prepare"]["bones"][0]["mesh"], "bone.ply");
  EXPECT_EQ(report["prepare"]["warnings"][0], "bone.ply: is open");
  EXPECT_EQ(report["frames"][0]["shortcomings"][0], "data: lost");
}

}  // namespace
}  // namespace musclewarp
