// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include "musclewarp/opensim/geometry_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "musclewarp/base/output_file.h"
#include "support/input_errors.h"
#include "support/temp_dir.h"

namespace musclewarp {
namespace {

namespace fs = std::filesystem;

// A model in Models/Leg, as in the folders of OpenSim's own models.
class GeometryFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    dir_ = TestTempDir();
    model_.path = dir_ + "/Models/Leg/leg.osim";
    fs::create_directories(dir_ + "/Models/Leg");
    geometry_.file = "femur.vtp";
  }
  std::string Write(const std::string& folder) {
    fs::create_directories(dir_ + "/" + folder);
    const std::string path = dir_ + "/" + folder + "/femur.vtp";
    WriteTextAtomically(path, "x");
    return path;
  }
  std::string Found() {
    return GeometryFile(model_, geometry_, {dir_ + "/given"});
  }
  std::string dir_;
  Model model_;
  ModelGeometry geometry_;
};

TEST_F(GeometryFiles, FoldersAreSearchedInTheOrderOfOpenSim) {
  // Each folder comes before those of the lines above it.
  for (const std::string& folder : {std::string("Geometry"),
                                    std::string("Models/Geometry"),
                                    std::string("given"),
                                    std::string("Models/Leg/Geometry"),
                                    std::string("Models/Leg")}) {
    const std::string path = Write(folder);
    EXPECT_EQ(Found(), path);
  }
}

TEST_F(GeometryFiles, PathsMayBeAbsoluteOrOfAnotherComputer) {
  const std::string path = Write("elsewhere");
  geometry_.file = path;
  EXPECT_EQ(Found(), path);
  geometry_.file = "C:/OpenSim/Geometry/femur.vtp";
  ExpectInputError([&] { Found(); }, {"C:/OpenSim/Geometry/femur.vtp"});
  const std::string beside = Write("Models/Leg");
  EXPECT_EQ(Found(), beside);
}

TEST_F(GeometryFiles, SaysWhereItLooked) {
  fs::create_directories(dir_ + "/given");
  fs::create_directories(dir_ + "/Geometry");
  ExpectInputError(
      [&] { Found(); },
      {"leg.osim",
       "femur.vtp",
       dir_ + "/Models/Leg, " + dir_ + "/given, " + dir_ + "/Geometry",
       "geometry"});
}

}  // namespace
}  // namespace musclewarp
