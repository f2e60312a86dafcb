// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "tools/model_listing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/osim_models.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

std::string Listing(const std::string& model, const ModelSources& sources) {
  std::ostringstream screen;
  PrintModel(model, sources, screen);
  return screen.str();
}

// A leg whose shank has two meshes, of which one is there, with a muscle that
// can be used and one that cannot.
std::string LegWithMeshes() {
  std::string text = Model4(
      Joint4("PinJoint", "knee"),
      "",
      Muscle("good",
             Point4("a", "thigh", "0 0 0") + Point4("b", "shank", "0 0 0")) +
          Muscle("bad",
                 Point4("a", "thigh", "0 0 0") + Point4("b", "foot", "0 0 0")));
  const std::string shank = "<Body name=\"shank\"/>";
  text.replace(text.find(shank),
               shank.size(),
               "<Body name=\"shank\"><attached_geometry>"
               "<Mesh><mesh_file>tibia.ply</mesh_file></Mesh>"
               "<Mesh><mesh_file>fibula.ply</mesh_file></Mesh>"
               "</attached_geometry></Body>");
  return Written("leg.osim", text);
}

TEST(ModelListing, SaysWhatASceneCanName) {
  const std::string model = LegWithMeshes();
  const std::string folder = fs::path(model).parent_path().string();
  WriteTextAtomically(folder + "/tibia.ply", "x");
  const std::string text = Listing(model, {});
  EXPECT_THAT(text,
              AllOf(HasSubstr("model leg (" + model + ")"),
                    ContainsRegex("shank +PinJoint \"knee_joint\" on thigh"),
                    ContainsRegex("shank +tibia.ply +" + folder + "/tibia.ply"),
                    ContainsRegex("shank +fibula.ply +not there"),
                    ContainsRegex("good +thigh, shank"),
                    ContainsRegex("bad +NOT usable: .*/bodyset/foot"),
                    ContainsRegex("knee +degrees +0\n")));
  EXPECT_THAT(text, HasSubstr("\n  " + folder + "\n"));
}

TEST(ModelListing, FoldersOfMeshesAreSearched) {
  const std::string model = LegWithMeshes();
  const std::string folder = fs::path(model).parent_path().string() + "/bones";
  fs::create_directories(folder);
  WriteTextAtomically(folder + "/fibula.ply", "x");
  ModelSources sources;
  sources.geometry = {folder};
  EXPECT_THAT(Listing(model, sources),
              ContainsRegex("fibula.ply +" + folder + "/fibula.ply"));
}

TEST(ModelListing, RangesInAMotionAreInItsUnits) {
  const std::string model = LegWithMeshes();
  ModelSources sources;
  sources.motion = Written(
      "m.mot",
      "m\ninDegrees=yes\nendheader\ntime knee force\n0 -30 1\n2 45 1\n");
  EXPECT_THAT(Listing(model, sources),
              AllOf(ContainsRegex("knee +degrees +0 +-30 to 45\n"),
                    HasSubstr("2 rows, 0 to 2 s"),
                    HasSubstr("1 column that is no coordinate of " + model +
                              " is left out: force")));
  sources.motion = "none.mot";
  ExpectInputError([&] { Listing(model, sources); }, {"none.mot"});
}

}  // namespace
}  // namespace musclewarp
