// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>
#include <string>

#include "support/temp_dir.h"
#include "tools/programs_data.h"
#include "tools/run_program.h"

namespace musclewarp {
namespace {

using Json = nlohmann::json;

// Paper mode: nearly nothing inside, volume kept, both solvers alike.
void ExpectApart(const Json& none, const Json& paper) {
  ASSERT_EQ(none["frames"].size(), paper["frames"].size());
  for (size_t i = 0; i < paper["frames"].size(); ++i) {
    const Json& frame = paper["frames"][i];
    EXPECT_EQ(frame["stop_reason"], "converged") << frame["name"];
    const int before = none["frames"][i]["intersections"]["vertices_inside"];
    // The aim is a tenth; what is reached is nearly nothing.
    EXPECT_LE(frame["intersections"]["vertices_inside"].get<int>(),
              before / 100)
        << frame["name"];
    for (const Json& muscle : frame["muscles"]) {
      EXPECT_NEAR(muscle["volume_error"], 0, 1e-6) << frame["name"];
    }
  }
}

TEST_F(ProgramsDataTest, PaperContactPartsThePapersCaseInBothSolvers) {
  const std::string dir = TestTempDir();
  const std::string scene = "bodyparts3d_gluteals";
  const Json none = Deform(scene, "reference", dir + "/none");
  for (const char* solver : {"reference", "ceres"}) {
    ExpectApart(none,
                Deform(scene, solver, dir + "/" + solver, "--contact=paper"));
  }
}

TEST_F(ProgramsDataTest, PaperContactPartsTheHamstrings) {
  const std::string dir = TestTempDir();
  const std::string scene = "bodyparts3d_hamstrings";
  ExpectApart(Deform(scene, "ceres", dir + "/none"),
              Deform(scene, "ceres", dir + "/paper", "--contact=paper"));
}

TEST_F(ProgramsDataTest, PaperContactPartsTheLhdlHip) {
  const std::string dir = TestTempDir();
  for (const char* level : {"coarse", "fine"}) {
    ExpectApart(Deform("lhdl_hip", "ceres", dir + "/none", "--frames=last"),
                Deform("lhdl_hip",
                       "ceres",
                       dir + "/paper",
                       std::string("--frames=last --contact=paper "
                                   "--contact_level=") +
                           level));
  }
}

TEST_F(ProgramsDataTest, PaperContactDoesNotDependOnThreads) {
  const std::string dir = TestTempDir();
  for (const char* level : {"coarse", "fine"}) {
    for (const char* threads : {"1", "3"}) {
      Deform("bodyparts3d_gluteals",
             "ceres",
             dir + "/" + threads,
             std::string("--frames=last --contact=paper --contact_level=") +
                 level + " --threads=" + threads);
    }
    for (const char* muscle : {"gluteus_medius", "gluteus_minimus"}) {
      const std::string file = std::string("/frame_0004/") + muscle + ".ply";
      EXPECT_EQ(FileText(dir + "/1" + file), FileText(dir + "/3" + file));
    }
  }
}

TEST_F(ProgramsDataTest, LhdlFlexionRunsToTheEndInContact) {
  // The paper knows no attachments, and muscles neither slide nor have fibres.
  const Json report = Deform("lhdl_hip_motion",
                             "ceres",
                             TestTempDir(),
                             "--contact=paper --attachments=none "
                             "--lines=fixed --bending_weight=0");
  EXPECT_EQ(report["frames"].size(), 36u);
  for (const Json& frame : report["frames"]) {
    EXPECT_TRUE(frame["usable"]) << frame["name"];
    for (const Json& muscle : frame["muscles"]) {
      EXPECT_NEAR(muscle["volume_error"], 0, 1e-4) << frame["name"];
    }
    // Of 19 427 vertices; 1 was seen.
    EXPECT_LE(frame["intersections"]["vertices_inside"], 5) << frame["name"];
  }
}

}  // namespace
}  // namespace musclewarp
